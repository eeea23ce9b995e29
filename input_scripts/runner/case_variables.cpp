#include "runner/case_variables.h"

#include "core/input_error.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace encased_column {

namespace {

const std::string* value_of(const Settings& settings, const std::string& name)
{
  for (const Setting& setting : settings)
    if (setting.first == name) return &setting.second;
  return nullptr;
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

Settings given_variables(const Deck& deck, const Settings& row, const std::string& resolution,
                         const Settings& set)
{
  Settings all = row;
  if (!resolution.empty()) all.emplace_back("resolution", resolution);
  all.insert(all.end(), set.begin(), set.end());
  for (const Setting& setting : all)
    if (!deck.find(setting.first))
      throw InputError("deck " + deck.name + " has no variable '" + setting.first +
                       "', expected one of: " + joined(deck.names()));
  return last_of_each(all);
}

Settings asked_variables(const Deck& deck, const Settings& given)
{
  Settings asked;
  for (const DeckVariable& variable : deck.variables) {
    const std::string* own = value_of(given, variable.name);
    std::string value = own ? *own : variable.value;
    // As the host does where it reads the line: only what stands before it is known there.
    for (const Setting& before : asked) {
      const std::string reference = "${" + before.first + "}";
      const std::size_t at = value.find(reference);
      if (at != std::string::npos) value.replace(at, reference.size(), before.second);
    }
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
    const std::string* other = value_of(there, name);
    if (!other) return {"nothing", name + "=" + value};
    if (!same_value(*other, value)) return {name + "=" + *other, name + "=" + value};
  }
  for (const auto& [name, value] : there)
    if (!value_of(now, name)) return {name + "=" + value, "nothing"};
  return {};
}

}  // namespace encased_column
