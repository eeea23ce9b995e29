// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>

namespace encased_column {

/// The number [SI] that `word` spells in the SI unit `unit` or in a part or multiple of it: "10.9
/// MPa", "5 %", "36.4 deg", "20e6". Angles must name their unit. Throws InputError naming
/// `keyword`.
double read_in_unit(const std::string& keyword, const std::string& word, const std::string& unit);

/// `value` [SI] for reading: in kPa or MPa, degrees or percent of strain where that is usual.
std::string in_usual_unit(double value, const std::string& unit, int digits = 4);

/// The same in the unit that would be usual for `like`, so that numbers side by side compare.
std::string in_unit_like(double value, double like, const std::string& unit, int digits = 3);

/// What in_usual_unit() writes behind the number; charts use it for axes. `size` decides between
/// kPa and MPa.
struct UsualUnit {
  std::string name;
  double size;  ///< in SI
};
UsualUnit usual_unit(double size, const std::string& unit);

}  // namespace encased_column
