#pragma once

#include <map>
#include <optional>
#include <string>

namespace encased_column {

/// The contact forces of the whole specimen at one time.
struct ContactSample {
  double axial_strain;             ///< of the specimen [-]
  double contacts;                 ///< their number [-]
  double mean_force;               ///< [N]
  double largest_force;            ///< [N]
  std::map<double, double> share;  ///< of the contacts that bear a level [-], by the level [N]
};

/// The level [N] whose share of the contacts stands below `heading`, which `fix output/contacts`
/// writes as "share_above_20N [-]"; nothing for other headings. Throws InputError if the level is
/// no number.
std::optional<double> level_of_share(const std::string& heading);

}  // namespace encased_column
