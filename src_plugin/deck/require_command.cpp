// SPDX-License-Identifier: GPL-2.0-only
#include "deck/require_command.h"

#include "deck/variable_rule.h"

#include "input.h"
#include "variable.h"

namespace encased_column {

const KeywordTable RequireCommand::keywords{
    {"variable", 1, "-", "name of the variable that is looked at"},
    {"positive", 0, "-", "it must be a number larger than zero"},
    {"not_negative", 0, "-", "it must be zero or larger"},
    {"between", 2, "-", "it must be a number from the first to the second"},
    {"whole", 1, "-", "it must be a whole number, this one or larger"},
    {"choice", 1, "-", "it must be this word (repeated: one of these)", true},
};

void RequireCommand::command(int narg, char** arg)
{
  try {
    const Options options = keywords.read(narg, arg, 0);
    std::string name = options.word("variable");
    const char* const value = input->variable->retrieve(name.data());
    if (!value)
      throw InputError("'variable' must name a variable, found '" + name +
                       "' and there is none, define it before");
    require_rule(options, name, value);
  } catch (const InputError& problem) {
    error->all(FLERR, problem.what());
  }
}

}  // namespace encased_column
