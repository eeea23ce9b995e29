// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace encased_column {

/// Input the user can mend: one sentence with the keyword, the rule, the value found and what to
/// write. Kernels and readers throw it; each adapter catches it once and ends the run with it.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// `x` as a user would write it: shortest form of six digits, "1e-05" and not "0.000010".
std::string in_words(double x);

/// `words` as a deck has them, with blanks between.
std::string joined(const std::vector<std::string>& words);

/// The finite number that `word` spells, the whole of it; throws InputError naming `keyword`
/// otherwise ("0.1.7", "1e", "nan" and "5mm" are refused).
double read_number(const std::string& keyword, const std::string& word);

/// The same for an integer.
long read_integer(const std::string& keyword, const std::string& word);

}  // namespace encased_column
