// SPDX-License-Identifier: GPL-2.0-only
#include "servo/wall_motion.h"

#include "core/input_error.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

const std::vector<Keyword>& WallMotion::keywords()
{
  static const std::vector<Keyword> keywords{
      {"type", 1, "-", "atom type that stands for the material of the wall"},
      {"hold", 0, "-", "stands still (default)"},
      {"velocity", 1, "m/s", "moves at this speed, positive towards the specimen"},
      {"servo", 1, "Pa", "moves so that the grains press with this stress, zero or larger"},
      {"ramp", 1, "steps", "with `servo`: the target gets there linearly in so many steps"},
      {"gain", 1, "-", "part of the missing force closed per step, 0.001 to 0.8 (default 0.8)"},
      {"speed_limit", 1, "m/s", "largest servo speed (default 1e-5 radii per step)"},
      {"patience", 1, "steps",
       "after more in a row at the speed limit, one way, the run stops (default 50000)"},
  };
  return keywords;
}

void WallMotion::read(const Options& options, long step, double stress_now)
{
  if (options.has("hold") + options.has("velocity") + options.has("servo") > 1)
    throw InputError(
        "a wall does one of 'hold', 'velocity' and 'servo', found more than one, "
        "write one of them");
  if (options.has("ramp") && !options.has("servo"))
    throw InputError("'ramp' goes with 'servo', found it alone, write 'servo STRESS ramp STEPS'");
  gain_ = options.between("gain", 1e-3, 0.8, gain_);
  if (options.has("speed_limit")) speed_limit_ = options.positive("speed_limit");
  patience_ = options.integer("patience", 1, patience_);
  if (options.has("hold")) mode_ = Mode::hold;
  if (options.has("velocity")) {
    mode_ = Mode::velocity;
    velocity_ = options.number("velocity");
  }
  if (options.has("servo")) {
    mode_ = Mode::servo;
    memory_ = ServoMemory();
    steps_at_limit_ = 0;
    const long ramp = options.has("ramp") ? options.integer("ramp", 1) : 0;
    ramp_.start_from(stress_now, options.not_negative("servo", 0.0), ramp, step);
  }
  // What goes on from before.
  if (mode_ == Mode::hold) options.assume("hold", "");
  if (mode_ == Mode::velocity) options.assume("velocity", velocity_);
  if (mode_ == Mode::servo) options.assume("servo", ramp_.target());
  if (speed_limit_ > 0.0) options.assume("speed_limit", speed_limit_);
}

double WallMotion::speed(long step, double dt, const WallLoad& load, double area,
                         double usual_limit)
{
  if (mode_ == Mode::hold) return 0.0;
  if (mode_ == Mode::velocity) return velocity_;
  const double limit = speed_limit_ > 0.0 ? speed_limit_ : usual_limit;
  const double speed = steady_servo_speed(load, target(step), area, gain_, dt, limit, memory_);
  count_step(speed, limit);
  return speed;
}

void WallMotion::count_step(double speed, double limit)
{
  if (std::abs(speed) < limit)
    steps_at_limit_ = 0;
  else if (speed > 0.0)
    steps_at_limit_ = std::max(steps_at_limit_, 0L) + 1;
  else
    steps_at_limit_ = std::min(steps_at_limit_, 0L) - 1;
}

std::array<double, WallMotion::numbers> WallMotion::state() const
{
  const auto ramp = ramp_.state();
  return {static_cast<double>(mode_),
          velocity_,
          gain_,
          memory_.even_speed,
          speed_limit_,
          static_cast<double>(patience_),
          static_cast<double>(steps_at_limit_),
          ramp[0],
          ramp[1],
          ramp[2],
          ramp[3]};
}

void WallMotion::restore(const std::array<double, numbers>& state)
{
  mode_ = static_cast<Mode>(static_cast<int>(state[0]));
  velocity_ = state[1];
  gain_ = state[2];
  memory_.even_speed = state[3];
  speed_limit_ = state[4];
  patience_ = static_cast<long>(state[5]);
  steps_at_limit_ = static_cast<long>(state[6]);
  ramp_.restore({state[7], state[8], state[9], state[10]});
}

}  // namespace encased_column
