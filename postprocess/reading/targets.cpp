// SPDX-License-Identifier: GPL-2.0-only
#include "reading/targets.h"

#include "core/constants.h"
#include "core/input_error.h"

namespace encased_column {

namespace {

bool starts_with(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

std::optional<double> optional_number(const std::string& column, const std::string& word)
{
  if (word.empty()) return std::nullopt;
  return read_number(column, word);
}

}  // namespace

Targets::Targets(const std::filesystem::path& file) : table_(file)
{
  for (const char* column : {"set", "quantity", "unit", "condition", "value_test", "value_model"})
    table_.words(column);
}

Published Targets::find(const std::string& set, const std::string& quantity,
                        const std::string& condition) const
{
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    if (table_.words("set")[row] != set) continue;
    if (!starts_with(table_.words("quantity")[row], quantity)) continue;
    if (!starts_with(table_.words("condition")[row], condition)) continue;
    return {optional_number("value_test", table_.words("value_test")[row]),
            optional_number("value_model", table_.words("value_model")[row])};
  }
  return {};
}

std::optional<Strength> Targets::strength(const std::string& set, bool laboratory) const
{
  const Published angle = find(set, "apparent friction angle", "");
  const Published cohesion = find(set, "apparent cohesion", "");
  const auto phi = laboratory ? angle.laboratory : angle.model;
  const auto c = laboratory ? cohesion.laboratory : cohesion.model;
  if (!phi || !c) return std::nullopt;
  return Strength{*phi * pi / 180.0, *c * 1e3};
}

std::vector<TargetRow> Targets::all() const
{
  std::vector<TargetRow> rows;
  for (std::size_t i = 0; i < table_.rows(); ++i)
    rows.push_back({table_.words("set")[i],
                    table_.words("quantity")[i],
                    table_.words("unit")[i],
                    table_.words("condition")[i],
                    table_.has("source") ? table_.words("source")[i] : "",
                    {optional_number("value_test", table_.words("value_test")[i]),
                     optional_number("value_model", table_.words("value_model")[i])}});
  return rows;
}

std::vector<TargetRow> Targets::rows_of(const std::string& set, const std::string& quantity) const
{
  std::vector<TargetRow> rows;
  for (const TargetRow& row : all())
    if (row.set == set && starts_with(row.quantity, quantity)) rows.push_back(row);
  return rows;
}

std::vector<DensityPoint> Targets::densities() const
{
  std::vector<DensityPoint> points;
  for (const TargetRow& row : rows_of("column_density", "porosity")) {
    const std::optional<double> density = row.words().relative_density;
    if (density && row.published.laboratory)
      points.push_back({*density, *row.published.laboratory});
  }
  return points;
}

std::optional<StripLimit> Targets::strip_limit() const
{
  std::optional<StripLimit> limit;
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    if (table_.words("set")[row] != "geotextile") continue;
    const std::string& condition = table_.words("condition")[row];  // "8 % elongation"
    const double strain = 0.01 * read_number("condition", condition.substr(0, condition.find(' ')));
    const double tension = 1e3 * read_number("value_test", table_.words("value_test")[row]);
    if (!limit || strain > limit->strain) limit = StripLimit{tension, strain};
  }
  return limit;
}

std::string confining_condition(double confining_stress)
{
  return "sigma3=" + in_words(confining_stress / 1e3) + " kPa";
}

}  // namespace encased_column
