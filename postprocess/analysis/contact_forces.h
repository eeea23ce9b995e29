#pragma once

#include <array>

namespace encased_column {

/// Force levels of the study's Figure 13 [N].
constexpr std::array<double, 4> force_levels{5.0, 20.0, 40.0, 60.0};

/// The contact forces of the whole specimen at one time.
struct ContactSample {
  double axial_strain;                            ///< of the specimen [-]
  double contacts;                                ///< their number [-]
  double mean_force;                              ///< [N]
  double largest_force;                           ///< [N]
  std::array<double, force_levels.size()> share;  ///< of the contacts that bear each level [-]
};

}  // namespace encased_column
