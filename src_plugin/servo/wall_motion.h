// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "core/linear_ramp.h"
#include "servo/servo_law.h"

#include <array>
#include <cstdlib>
#include <vector>

namespace encased_column {

/// How a rigid wall moves: it stands still, goes at a speed, or follows a stress.
class WallMotion {
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
  /// that cannot bear the stress, or are not there, would be run over without a message.
  bool is_out_of_reach() const { return std::abs(steps_at_limit_) > patience_; }
  /// Stress [Pa] that is followed at `step`.
  double target(long step) const { return ramp_.at(step); }
  /// Steps after `step` until the target stands still.
  long ramp_left(long step) const { return follows_stress() ? ramp_.steps_left(step) : 0L; }
  long patience() const { return patience_; }

  /// All there is to know of it, for a restart file.
  static constexpr int numbers = 7 + LinearRamp::numbers;
  std::array<double, numbers> state() const;
  void restore(const std::array<double, numbers>& state);

 private:
  enum class Mode { hold, velocity, servo };
  void count_step(double speed, double limit);

  Mode mode_ = Mode::hold;
  double velocity_ = 0.0;
  LinearRamp ramp_{0.0, LinearRamp::Division::of_the_steps_gone};  ///< of the stress [Pa]
  double gain_ = 0.8;
  ServoMemory memory_;
  double speed_limit_ = 0.0;  ///< 0: the wall's usual limit
  long patience_ = 50000;
  long steps_at_limit_ = 0;  ///< negative: away from the specimen
};

}  // namespace encased_column
