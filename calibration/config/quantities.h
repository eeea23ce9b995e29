// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// Something a test gives that a calibration may be told to meet.
struct Quantity {
  std::string name, unit, meaning;
  bool of_several = false;    ///< of the tests at several confining stresses together
  bool proportional = false;  ///< scatters between packings in proportion to its value
};

/// All of them, as the user page lists them.
const std::vector<Quantity>& quantities();

/// The one called `name`; nullptr if there is none.
const Quantity* find_quantity(const std::string& name);

}  // namespace encased_column
