// SPDX-License-Identifier: GPL-2.0-only
#include "config/curve_file.h"

#include "config/units.h"
#include "core/input_error.h"
#include "runner/text_file.h"

namespace encased_column {

namespace {

/// The column that begins with `name`, in SI units: its heading names the unit in brackets.
std::vector<double> column(const std::vector<std::vector<std::string>>& rows,
                           const std::string& name, const std::string& unit,
                           const std::string& place)
{
  std::string headings;
  for (std::size_t i = 0; i < rows.front().size(); ++i) {
    const std::string& heading = rows.front()[i];
    headings += (i ? ", " : "") + heading;
    const std::size_t bracket = heading.find(" [");
    if (heading.substr(0, bracket) != name || bracket == std::string::npos) continue;
    const std::string own = heading.substr(bracket + 2, heading.size() - bracket - 3);
    std::vector<double> values;
    for (std::size_t row = 1; row < rows.size(); ++row)
      values.push_back(read_in_unit("'" + heading + "' of the file of " + place,
                                    (i < rows[row].size() ? rows[row][i] : "") + " " + own, unit));
    return values;
  }
  throw InputError("the file of " + place + " must have a column '" + name + " [" + unit +
                   "]', found '" + headings + "', write it in its first line");
}

}  // namespace

SampledCurve read_curve_file(const std::filesystem::path& file, const std::string& place)
{
  const auto rows =
      csv_rows(read_text_file(file, place + ", the file '" + shown(file) + "',"), shown(file));
  if (rows.size() < 3)
    throw InputError("the file of " + place +
                     " must have a line of headings and two rows at least, " + "found " +
                     std::to_string(rows.size()) + " lines, add rows");
  try {
    const std::vector<double> strain = column(rows, "axial_strain", "-", place);
    return SampledCurve(strain, column(rows, "deviatoric_stress", "Pa", place));
  } catch (const InputError& problem) {
    const std::string text = problem.what();
    throw InputError(text.find(place) == std::string::npos ? place + ": " + text : text);
  }
}

}  // namespace encased_column
