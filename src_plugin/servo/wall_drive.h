#pragma once

#include "core/keyword_table.h"
#include "servo/servo_law.h"

#include <array>
#include <cstdlib>
#include <vector>

namespace encased_column {

/// How a rigid wall moves: it stands still, goes at a speed, or follows a stress.
class WallDrive {
 public:
  /// The keywords read() knows, for the tables of the walls.
  static const std::vector<Keyword>& keywords();

  /// Takes over what the deck gave; a ramp starts at `step` from the stress `stress_now` [Pa].
  /// Throws InputError.
  void read(const Options& options, long step, double stress_now);

  /// True where speed() goes by the load; otherwise area and limit do not count.
  bool follows_stress() const { return mode_ == Mode::servo; }
  /// Speed [m/s] towards the specimen at `step` of length `dt` [s].
  double speed(long step, double dt, const WallLoad& load, double area, double usual_limit);

  /// True after more than `patience` steps in a row at the speed limit in one direction: grains
  /// that cannot bear the stress, or are not there, would be run over in silence.
  bool is_out_of_reach() const { return std::abs(steps_at_limit_) > patience_; }
  double target(long step) const;  ///< stress [Pa] that is followed at `step`
  /// Steps after `step` until the target stands still.
  long ramp_left(long step) const;
  long patience() const { return patience_; }

  /// All it holds, in numbers, for a restart file.
  using State = std::array<double, 11>;
  State state() const;
  void resume(const State& state);

 private:
  enum class Mode { hold, velocity, servo };
  void count_step(double speed, double limit);

  Mode mode_ = Mode::hold;
  double velocity_ = 0.0;
  double target_ = 0.0, ramp_from_ = 0.0;
  long ramp_start_ = 0, ramp_steps_ = 0;
  double gain_ = 0.8;
  ServoMemory memory_;
  double speed_limit_ = 0.0;  ///< 0: the wall's usual limit
  long patience_ = 50000;
  long steps_at_limit_ = 0;  ///< negative: away from the specimen
};

}  // namespace encased_column
