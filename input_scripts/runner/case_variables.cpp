// SPDX-License-Identifier: GPL-2.0-only
#include "runner/case_variables.h"

#include "core/input_error.h"
#include "runner/text_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace encased_column {

namespace {

void replace_reference(std::string& value, const std::string& name, const std::string& by)
{
  const std::string reference = "${" + name + "}";
  const std::size_t at = value.find(reference);
  if (at != std::string::npos) value.replace(at, reference.size(), by);
}

std::optional<double> number(const std::string& word)
{
  if (word.empty() || std::isspace(static_cast<unsigned char>(word.front()))) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (*end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

Settings last_of_each(const Settings& settings)
{
  Settings merged;
  for (const Setting& setting : settings) {
    const auto known = std::find_if(merged.begin(), merged.end(),
                                    [&](const Setting& s) { return s.first == setting.first; });
    if (known == merged.end())
      merged.push_back(setting);
    else
      known->second = setting.second;
  }
  return merged;
}

Settings given_variables(const Settings& row, const std::string& resolution, const Settings& set)
{
  Settings all = row;
  if (!resolution.empty()) all.emplace_back("resolution", resolution);
  all.insert(all.end(), set.begin(), set.end());
  return last_of_each(all);
}

void check_names(const Deck& deck, const Settings& given)
{
  for (const Setting& setting : given)
    if (!deck.find(setting.first))
      throw InputError("deck " + deck.name + " has no variable '" + setting.first +
                       "', expected one of: " + joined(deck.names()));
}

Settings with_found_tables(const Deck& deck, Settings given)
{
  namespace fs = std::filesystem;
  for (auto& [name, value] : given) {
    const fs::path file = value;
    if (file.extension() != ".csv") continue;
    if (!file.has_parent_path() && fs::is_regular_file(deck.common / file)) {
      value = std::string(common_of_case) + "/" + value;
      continue;
    }
    if (!fs::is_regular_file(file))
      throw InputError("'" + name + "' must be a CSV file in '" + shown(deck.common) +
                       "' or the path of one, found no '" + value.substr(0, 200) +
                       "', check its name");
    value = fs::absolute(file).lexically_normal();
  }
  return given;
}

Settings asked_variables(const Deck& deck, const Settings& given)
{
  Settings asked;
  for (const DeckVariable& variable : deck.variables) {
    const std::string* own = value_in(given, variable.name);
    std::string value = own ? *own : variable.value;
    // As the host does where it reads the line: only what stands before it is known there.
    replace_reference(value, "common", common_of_case);
    for (const Setting& before : asked) replace_reference(value, before.first, before.second);
    asked.emplace_back(variable.name, value);
  }
  return asked;
}

bool same_value(const std::string& a, const std::string& b)
{
  if (a == b) return true;
  const auto x = number(a), y = number(b);
  return x && y && *x == *y;
}

Difference first_difference(const Settings& there, const Settings& now)
{
  for (const auto& [name, value] : now) {
    const std::string* other = value_in(there, name);
    if (!other) return {"nothing", name + "=" + value};
    if (!same_value(*other, value)) return {name + "=" + *other, name + "=" + value};
  }
  for (const auto& [name, value] : there)
    if (!value_in(now, name)) return {name + "=" + value, "nothing"};
  return {};
}

Settings read_used_variables(const std::filesystem::path& file)
{
  const std::string name = shown(file);
  const auto rows = csv_rows(read_text_file(file, "'" + name + "'"), name);
  if (rows.empty() || rows.front() != std::vector<std::string>{"name", "style", "value"})
    throw InputError("'" + name + "' must begin with 'name,style,value', found something else, " +
                     "run the case again");
  Settings used;
  for (std::size_t n = 1; n < rows.size(); ++n) used.emplace_back(rows[n][0], rows[n][2]);
  return used;
}

Settings confirmed_variables(const std::string& id, const Settings& asked, const Settings& used)
{
  Settings confirmed;
  for (const auto& [name, value] : asked) {
    const std::string* found = value_in(used, name);
    if (!found)
      throw InputError("variable '" + name + "' of case '" + id +
                       "' must be used as it was asked " +
                       "for, found that the run does not know it, write 'record_variables file " +
                       variables_file + "' behind the last variable of its deck");
    if (!same_value(*found, value))
      throw InputError("variable '" + name + "' of case '" + id +
                       "' must be used as it was asked " + "for, found " + *found +
                       " in the run and " + value +
                       " asked for, look in its deck where the variable is set besides");
    confirmed.emplace_back(name, *found);
  }
  return confirmed;
}

}  // namespace encased_column
