// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <algorithm>
#include <array>

namespace encased_column {

/// A number that goes linearly with the steps to its target and then stays: the pressure on a
/// sleeve, the stress a servo follows.
class LinearRamp {
 public:
  /// When the way is divided by the number of steps. Both are the same number but for its last bit,
  /// and pressure and servo each keep theirs: a test done again gives the same history.
  enum class Division { of_the_way_gone, of_the_steps_gone };

  explicit LinearRamp(double start = 0.0, Division division = Division::of_the_way_gone)
      : from_(start),
        to_(start),
        division_(division)
  {
  }

  /// Heads for `target` over `steps` steps from step `now` on (0: at once), starting at the value
  /// of `now`.
  void set(double target, long steps, long now) { start_from(at(now), target, steps, now); }
  /// The same, starting at a value that was measured.
  void start_from(double start, double target, long steps, long now)
  {
    from_ = start;
    to_ = target;
    begin_ = now;
    steps_ = steps;
  }

  double at(long step) const
  {
    if (step >= begin_ + steps_) return to_;
    const double gone = static_cast<double>(step - begin_), all = static_cast<double>(steps_);
    const double way = to_ - from_;
    return from_ + (division_ == Division::of_the_way_gone ? way * gone / all : way * (gone / all));
  }
  double target() const { return to_; }
  /// Steps until the target is reached.
  long steps_left(long now) const { return std::max(0L, begin_ + steps_ - now); }

  /// All there is to know of it, for a restart file.
  static constexpr int numbers = 4;
  std::array<double, numbers> state() const
  {
    return {from_, to_, static_cast<double>(begin_), static_cast<double>(steps_)};
  }
  void restore(const std::array<double, numbers>& state)
  {
    from_ = state[0];
    to_ = state[1];
    begin_ = static_cast<long>(state[2]);
    steps_ = static_cast<long>(state[3]);
  }

 private:
  double from_, to_;
  long begin_ = 0, steps_ = 0;
  Division division_;
};

}  // namespace encased_column
