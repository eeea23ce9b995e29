// SPDX-License-Identifier: GPL-2.0-only
#include "config/quantities.h"

namespace encased_column {

const std::vector<Quantity>& quantities()
{
  static const std::vector<Quantity> all{
      {"secant_modulus", "Pa", "E50: half of the peak q over the axial strain where it is reached",
       false, true},
      {"peak_q", "Pa", "largest deviatoric stress", false, true},
      {"peak_strain", "-", "axial strain of it"},
      {"end_q", "Pa", "mean deviatoric stress over the last 1 % of axial strain", false, true},
      {"end_ratio", "-", "end_q over peak_q: 1 for a level curve"},
      {"end_volumetric_strain", "-", "volumetric strain at the end, compression positive"},
      {"radial_strain_25", "-", "expansion at a quarter of the height, at the end"},
      {"radial_strain_50", "-", "expansion at mid height, at the end"},
      {"radial_strain_75", "-", "expansion at three quarters of the height, at the end"},
      {"porosity", "-", "at the start of shear, overlaps counted once"},
      {"friction_angle", "rad", "apparent, of the line through the peaks of all its cases", true},
      {"cohesion", "Pa", "apparent, of the same line", true},
  };
  return all;
}

const Quantity* find_quantity(const std::string& name)
{
  for (const Quantity& one : quantities())
    if (one.name == name) return &one;
  return nullptr;
}

}  // namespace encased_column
