// SPDX-License-Identifier: GPL-2.0-only
#include "packing/gradation_file.h"

#include "core/input_error.h"

#include <iomanip>
#include <istream>
#include <ostream>
#include <sstream>

namespace encased_column {

namespace {

const char header[] = "diameter_low [m],diameter_high [m],mass_percent [%]";

std::string trimmed(const std::string& text)
{
  const char blanks[] = " \t\r";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> cells_of(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(trimmed(cell));
  return cells;
}

void write_sizes(std::ostream& out, const std::string& by, const CharacteristicSizes& sizes)
{
  out << "# d10 by " << by << " [m]," << sizes.d10 << "\n"
      << "# d30 by " << by << " [m]," << sizes.d30 << "\n"
      << "# d60 by " << by << " [m]," << sizes.d60 << "\n"
      << "# Cu by " << by << " [-]," << sizes.uniformity() << "\n"
      << "# Cc by " << by << " [-]," << sizes.curvature() << "\n";
}

}  // namespace

Gradation read_gradation(std::istream& in, const std::string& file)
{
  Gradation gradation;
  bool has_header = false;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    const std::string place = file + ":" + std::to_string(number);
    if (!has_header) {
      if (line != header)
        throw InputError("'gradation' " + place + " must start with the line '" + header +
                         "', found '" + line + "', write it above the classes");
      has_header = true;
      continue;
    }
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != 3)
      throw InputError("'gradation' " + place + " must have 3 values, found " +
                       std::to_string(cells.size()) + ", write '" + header + "'");
    gradation.push_back({read_number("gradation " + place, cells[0]),
                         read_number("gradation " + place, cells[1]),
                         read_number("gradation " + place, cells[2])});
  }
  try {
    check_gradation(gradation);
  } catch (const InputError& problem) {
    throw InputError("'gradation' " + file + ": " + problem.what());
  }
  return gradation;
}

void write_gradation(std::ostream& out, const Gradation& wanted,
                     const std::vector<ClassContent>& achieved, const PackingSummary& summary)
{
  out << "diameter_low [m],diameter_high [m],mass_percent_wanted [%],mass_percent_achieved [%],"
         "count [-]\n"
      << std::setprecision(8);
  for (std::size_t k = 0; k < wanted.size(); ++k)
    out << wanted[k].diameter_low << "," << wanted[k].diameter_high << "," << wanted[k].mass_percent
        << "," << achieved[k].mass_percent << "," << achieved[k].count << "\n";
  out << "# count [-]," << summary.count << "\n"
      << "# porosity at full size [-]," << summary.porosity << "\n";
  write_sizes(out, "sieve", summary.by_sieve);
  write_sizes(out, "grain", summary.by_grain);
}

Gradation sieved_gradation(Gradation wanted, const std::vector<ClassContent>& achieved)
{
  for (std::size_t k = 0; k < wanted.size(); ++k) wanted[k].mass_percent = achieved[k].mass_percent;
  return wanted;
}

}  // namespace encased_column
