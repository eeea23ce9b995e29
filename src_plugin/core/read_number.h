#pragma once

#include <string>

namespace encased_column {

/// The finite number that `word` spells, the whole of it; throws InputError naming `keyword`
/// otherwise ("0.1.7", "1e", "nan" and "5mm" are refused).
double read_number(const std::string& keyword, const std::string& word);

/// The same for an integer.
long read_integer(const std::string& keyword, const std::string& word);

}  // namespace encased_column
