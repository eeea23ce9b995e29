// SPDX-License-Identifier: GPL-2.0-only
#include "core/input_error.h"

#include <charconv>
#include <cmath>
#include <sstream>

namespace encased_column {

std::string in_words(double x)
{
  std::ostringstream text;
  text << x;
  return text.str();
}

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

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
