// SPDX-License-Identifier: GPL-2.0-only
#include "tables/page_tables.h"

#include "core/input_error.h"
#include "reading/deck_inputs.h"

#include <cmath>
#include <sstream>

namespace encased_column {

namespace {

struct Reading {
  std::string value, unit;
};

/// `input` in mm, kPa, MPa or kN/m where that spares zeros.
Reading for_an_engineer(const DeckInput& input)
{
  double value = 0.0;
  try {
    value = read_number(input.name, input.value);
  } catch (const InputError&) {
    return {input.value, input.unit};  // a word
  }
  const double size = std::abs(value);
  if (input.unit == "m" && size < 1.0) return {in_words(1e3 * value), "mm"};
  if (input.unit == "N/m" && size >= 1e3) return {in_words(value / 1e3), "kN/m"};
  if (input.unit == "Pa" && size >= 1e6) return {in_words(value / 1e6), "MPa"};
  if (input.unit == "Pa" && size >= 1e3) return {in_words(value / 1e3), "kPa"};
  return {in_words(value), input.unit};
}

}  // namespace

Rows input_rows(const CaseRun& run)
{
  Rows rows{{"variable", "value", "unit", "meaning"}};
  for (const DeckInput& input : deck_inputs(run)) {
    const Reading reading = for_an_engineer(input);
    rows.push_back({input.name, reading.value, reading.unit, input.meaning});
  }
  return rows;
}

Rows gradation_rows(const CaseRun& run)
{
  Rows rows{{"diameter [mm]", "mass wanted [%]", "mass achieved [%]", "grains [-]"}};
  const std::filesystem::path file = run.folder / "gradation.csv";
  if (!std::filesystem::exists(file)) return rows;
  const TextTable table(file);
  const auto low = table.numbers("diameter_low [m]"), high = table.numbers("diameter_high [m]");
  const auto wanted = table.numbers("mass_percent_wanted [%]");
  const auto achieved = table.numbers("mass_percent_achieved [%]");
  const auto count = table.numbers("count [-]");
  for (std::size_t i = 0; i < table.rows(); ++i)
    rows.push_back({in_words(1e3 * low[i]) + " to " + in_words(1e3 * high[i]), fixed(wanted[i], 2),
                    fixed(achieved[i], 2), fixed(count[i], 0)});
  return rows;
}

std::string repeat_arguments(const CaseRun& run, const std::string& command)
{
  std::string arguments = "--case " + run.id, ranks;
  if (!run.resolution.empty()) arguments += " --resolution " + run.resolution;
  std::istringstream words(command);
  for (std::string word, name, value; words >> word;) {
    if (word == "-np") words >> ranks;
    if (word != "-var" || !(words >> name >> value)) continue;
    if (name != "common" && name != "resolution" && name != "resume")
      arguments += " --set " + name + "=" + value;
  }
  return arguments + " --ranks " + (ranks.empty() ? "1" : ranks);
}

}  // namespace encased_column
