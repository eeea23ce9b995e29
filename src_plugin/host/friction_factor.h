// SPDX-License-Identifier: GPL-2.0-only
#pragma once

namespace encased_column {

/// A fix that makes all friction smaller while it stands in the deck: contacts slide at this factor
/// times the coefficients of the deck, which stay as they are. Whoever computes contacts looks at
/// it once a step.
class FrictionFactorOwner {
 public:
  virtual ~FrictionFactorOwner() = default;
  double friction_factor = 1.0;  ///< 0 to 1 [-]
};

}  // namespace encased_column
