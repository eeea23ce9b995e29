#include "servo/wall_drive.h"

#include "core/input_error.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

const std::vector<Keyword>& WallDrive::keywords()
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

void WallDrive::read(const Options& options, long step, double stress_now)
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
    target_ = options.not_negative("servo", 0.0);
    ramp_from_ = stress_now;
    ramp_start_ = step;
    ramp_steps_ = options.integer("ramp", 1, 0);
  }
}

double WallDrive::target(long step) const
{
  const long done = step - ramp_start_;
  if (done >= ramp_steps_) return target_;
  const double part = static_cast<double>(done) / static_cast<double>(ramp_steps_);
  return ramp_from_ + (target_ - ramp_from_) * part;
}

double WallDrive::speed(long step, double dt, const WallLoad& load, double area, double usual_limit)
{
  if (mode_ == Mode::hold) return 0.0;
  if (mode_ == Mode::velocity) return velocity_;
  const double limit = speed_limit_ > 0.0 ? speed_limit_ : usual_limit;
  const double speed = steady_servo_speed(load, target(step), area, gain_, dt, limit, memory_);
  count_step(speed, limit);
  return speed;
}

long WallDrive::ramp_left(long step) const
{
  return mode_ == Mode::servo ? std::max(ramp_start_ + ramp_steps_ - step, 0L) : 0L;
}

void WallDrive::count_step(double speed, double limit)
{
  if (std::abs(speed) < limit)
    steps_at_limit_ = 0;
  else if (speed > 0.0)
    steps_at_limit_ = std::max(steps_at_limit_, 0L) + 1;
  else
    steps_at_limit_ = std::min(steps_at_limit_, 0L) - 1;
}

WallDrive::State WallDrive::state() const
{
  const auto number = [](auto count) { return static_cast<double>(count); };
  return {number(mode_),
          velocity_,
          target_,
          ramp_from_,
          number(ramp_start_),
          number(ramp_steps_),
          gain_,
          memory_.even_speed,
          speed_limit_,
          number(patience_),
          number(steps_at_limit_)};
}

void WallDrive::resume(const State& state)
{
  const auto count = [&state](std::size_t n) { return static_cast<long>(state[n]); };
  mode_ = static_cast<Mode>(count(0));
  velocity_ = state[1];
  target_ = state[2];
  ramp_from_ = state[3];
  ramp_start_ = count(4);
  ramp_steps_ = count(5);
  gain_ = state[6];
  memory_.even_speed = state[7];
  speed_limit_ = state[8];
  patience_ = count(9);
  steps_at_limit_ = count(10);
}
}  // namespace encased_column
