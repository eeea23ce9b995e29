// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/input_error.h"
#include "core/keyword_table.h"

#include <string>
#include <vector>

namespace encased_column {

/// Throws InputError unless `value` of the variable `name` keeps the one rule that `rules` has:
/// `positive`, `not_negative`, `between`, `whole` or `choice`.
inline void require_rule(const Options& rules, const std::string& name, const std::string& value)
{
  const KeywordTable table{{name, 1, "-", ""}};
  const Options given = table.read({name, value});
  int kept = 0;
  if (rules.has("positive")) ++kept, given.positive(name);
  if (rules.has("not_negative")) ++kept, given.not_negative(name, 0.0);
  if (rules.has("between")) {
    const std::vector<std::string>& bounds = rules.all("between").front();
    ++kept,
        given.between(name, read_number("between", bounds[0]), read_number("between", bounds[1]));
  }
  if (rules.has("whole")) ++kept, given.integer(name, rules.integer("whole", 0));
  if (rules.has("choice")) {
    std::vector<std::string> allowed;
    for (const auto& words : rules.all("choice")) allowed.push_back(words.front());
    ++kept, given.choice(name, allowed);
  }
  if (kept != 1)
    throw InputError("'require' takes one rule, found " + std::to_string(kept) +
                     ", write for example 'require variable " + name + " positive'");
}

}  // namespace encased_column
