#pragma once

namespace encased_column {

/// A fix that acts while a step is made or at its end, but does not look at the velocities of the
/// grains there: `fix motion` need not complete them for it.
class IgnoresVelocity {
 protected:
  virtual ~IgnoresVelocity() = default;
};

}  // namespace encased_column
