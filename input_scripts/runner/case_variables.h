// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/case_record.h"
#include "runner/deck.h"

#include <filesystem>
#include <string>

namespace encased_column {

/// Each variable once, the last value of a name, where the name stood first.
Settings last_of_each(const Settings& settings);

/// What a case gives the host besides its deck: the variables of its row, then `resolution` (unless
/// empty), then those of --set; each once.
Settings given_variables(const Settings& row, const std::string& resolution, const Settings& set);

/// Throws InputError for a variable of `given` that the deck does not have.
void check_names(const Deck& deck, const Settings& given);

/// The folder `common` of a case, seen from its run folder.
inline const char* const common_of_case = "input/common";

/// Those of `given` that name a CSV file, by its name in `common` or by a path, with the path where
/// the run finds it: a case runs in a folder of its own. Throws InputError where there is none.
Settings with_found_tables(const Deck& deck, Settings given);

/// All variables of `deck` as a case with `given` asks for them, in the deck's order; those that
/// take their value from another one have it.
Settings asked_variables(const Deck& deck, const Settings& given);

/// True when both spell the same number, or are the same word.
bool same_value(const std::string& a, const std::string& b);

/// The first variable that has another value in `there` than in `now`, told in words; empty if
/// none.
struct Difference {
  std::string there, now;  ///< "sigma3=50e3", or "nothing"
  explicit operator bool() const { return !there.empty(); }
};
Difference first_difference(const Settings& there, const Settings& now);

/// The file in which a run says which variables it uses (`record_variables file variables.csv`).
inline const char* const variables_file = "variables.csv";

/// Reads it: name and value of each variable the host knew. Throws InputError for a file that is
/// none.
Settings read_used_variables(const std::filesystem::path& file);

/// Those of `used` that `asked` names, in its order. Throws InputError, for the case `id`, where
/// the run used another value than it was asked to, or does not know a variable at all.
Settings confirmed_variables(const std::string& id, const Settings& asked, const Settings& used);

}  // namespace encased_column
