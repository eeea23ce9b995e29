#include "core/read_number.h"

#include "core/input_error.h"

#include <charconv>
#include <cmath>

namespace encased_column {

double read_number(const std::string& keyword, const std::string& word)
{
  double value = 0.0;
  const char* begin = word.data();
  const char* end = begin + word.size();
  // from_chars knows no plus sign; "+-1" stays refused.
  if (end - begin > 1 && begin[0] == '+' && begin[1] != '-') ++begin;
  const auto [stopped, failure] = std::from_chars(begin, end, value);
  if (failure != std::errc() || stopped != end || !std::isfinite(value))
    throw InputError("'" + keyword + "' takes a finite number, found '" + word +
                     "', write for example '0.5' in its place");
  return value;
}

long read_integer(const std::string& keyword, const std::string& word)
{
  long value = 0;
  const char* end = word.data() + word.size();
  const auto [stopped, failure] = std::from_chars(word.data(), end, value);
  if (failure != std::errc() || stopped != end)
    throw InputError("'" + keyword + "' takes a whole number, found '" + word +
                     "', write for example '200' in its place");
  return value;
}

}  // namespace encased_column
