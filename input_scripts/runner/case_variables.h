#pragma once

#include "runner/deck.h"
#include "runner/setting.h"

#include <string>

namespace encased_column {

/// Each variable once, the last value of a name, where the name stood first.
Settings last_of_each(const Settings& settings);

/// What a case gives the host besides its deck: the variables of its row, then `resolution` (unless
/// empty), then those of --set; each once. Throws InputError, for the case `id`, for one that the
/// deck does not have.
Settings given_variables(const Deck& deck, const Settings& row, const std::string& resolution,
                         const Settings& set);

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

}  // namespace encased_column
