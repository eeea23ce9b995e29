// SPDX-License-Identifier: GPL-2.0-only
#include "core/keyword_table.h"

#include "core/input_error.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace encased_column {

namespace {

/// The end of a refusal: `value` in the place of the keyword's first one, the others as found.
std::string write_for_example(const Options& options, const std::string& keyword,
                              const std::string& value)
{
  std::vector<std::string> words = options.all(keyword).front();
  words.front() = value;
  return ", write for example '" + keyword + " " + joined(words) + "'";
}

[[noreturn]] void refuse(const Options& options, const std::string& keyword,
                         const std::string& rule, const std::string& found,
                         const std::string& example)
{
  throw InputError("'" + keyword + "' must be " + rule + ", found " + found +
                   write_for_example(options, keyword, example));
}

/// The middle of a range in as few digits as stay inside.
std::string middle_of(double low, double high)
{
  const double middle = 0.5 * low + 0.5 * high;
  for (int digits = 1;; ++digits) {
    std::ostringstream text;
    text.precision(digits);
    text << middle;
    const double rounded = read_number("", text.str());
    if ((rounded >= low && rounded <= high) || digits == std::numeric_limits<double>::max_digits10)
      return text.str();
  }
}

double require_between(const Options& options, const std::string& keyword, double low, double high,
                       double value)
{
  if (!(value >= low && value <= high))
    refuse(options, keyword, "between " + in_words(low) + " and " + in_words(high), in_words(value),
           middle_of(low, high));
  return value;
}

std::string list_of(const std::vector<std::string>& words)
{
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

}  // namespace

const std::vector<std::vector<std::string>>& Options::all(const std::string& keyword) const
{
  const auto entry = found_.find(keyword);
  if (entry == found_.end())
    throw InputError("keyword '" + keyword + "' is missing, add '" + keyword + " ...'");
  return entry->second;
}

std::string Options::word(const std::string& keyword) const
{
  return all(keyword).front().front();
}

std::string Options::word(const std::string& keyword, const std::string& otherwise) const
{
  if (has(keyword)) return word(keyword);
  assume(keyword, otherwise);
  return otherwise;
}

void Options::assume(const std::string& keyword, const std::string& value) const
{
  if (!has(keyword)) assumed_[keyword] = value;
}

void Options::assume(const std::string& keyword, double value) const
{
  assume(keyword, in_words(value));
}

std::string Options::understood() const
{
  std::vector<std::string> parts;
  for (const std::string& keyword : keywords_) {
    const auto given = found_.find(keyword);
    if (given != found_.end())
      for (const std::vector<std::string>& words : given->second)
        parts.push_back(words.empty() ? keyword : keyword + " " + joined(words));
    const auto assumed = assumed_.find(keyword);
    if (assumed != assumed_.end())
      parts.push_back(assumed->second.empty() ? keyword : keyword + " " + assumed->second);
  }
  return list_of(parts);
}

double Options::number(const std::string& keyword) const
{
  return read_number(keyword, word(keyword));
}

double Options::number(const std::string& keyword, double otherwise) const
{
  if (has(keyword)) return number(keyword);
  assume(keyword, otherwise);
  return otherwise;
}

double Options::positive(const std::string& keyword) const
{
  const double value = number(keyword);
  // The likely slip is the sign.
  if (!(value > 0.0))
    refuse(*this, keyword, "larger than zero", in_words(value),
           in_words(value < 0.0 ? -value : 1.0));
  return value;
}

double Options::positive(const std::string& keyword, double otherwise) const
{
  if (has(keyword)) return positive(keyword);
  assume(keyword, otherwise);
  return otherwise;
}

double Options::not_negative(const std::string& keyword, double otherwise) const
{
  const double value = number(keyword, otherwise);
  if (!(value >= 0.0)) refuse(*this, keyword, "zero or larger", in_words(value), in_words(-value));
  return value;
}

double Options::between(const std::string& keyword, double low, double high) const
{
  return require_between(*this, keyword, low, high, number(keyword));
}

double Options::between(const std::string& keyword, double low, double high, double otherwise) const
{
  return require_between(*this, keyword, low, high, number(keyword, otherwise));
}

long Options::integer(const std::string& keyword, long low) const
{
  const long value = read_integer(keyword, word(keyword));
  const std::string found = std::to_string(value);
  if (value < low)
    refuse(*this, keyword, std::to_string(low) + " or larger", found, std::to_string(low));
  constexpr long largest =
      std::numeric_limits<int>::max();  // the host counts steps and types in int
  if (value > largest)
    refuse(*this, keyword, "at most " + std::to_string(largest), found, std::to_string(largest));
  return value;
}

long Options::integer(const std::string& keyword, long low, long otherwise) const
{
  if (has(keyword)) return integer(keyword, low);
  assume(keyword, std::to_string(otherwise));
  return otherwise;
}

Vec3 Options::vector(const std::string& keyword) const
{
  const std::vector<std::string>& words = all(keyword).front();
  return Vec3(read_number(keyword, words.at(0)), read_number(keyword, words.at(1)),
              read_number(keyword, words.at(2)));
}

std::string Options::choice(const std::string& keyword,
                            const std::vector<std::string>& allowed) const
{
  const std::string value = word(keyword);
  if (std::find(allowed.begin(), allowed.end(), value) == allowed.end())
    throw InputError("'" + keyword + "' must be one of: " + list_of(allowed) + "; found '" + value +
                     "'" + write_for_example(*this, keyword, allowed.front()));
  return value;
}

std::string Options::choice(const std::string& keyword, const std::vector<std::string>& allowed,
                            const std::string& otherwise) const
{
  if (has(keyword)) return choice(keyword, allowed);
  assume(keyword, otherwise);
  return otherwise;
}

std::string KeywordTable::names() const
{
  std::vector<std::string> names;
  for (const Keyword& keyword : keywords_) names.push_back(keyword.name);
  return list_of(names);
}

std::vector<Keyword>::const_iterator KeywordTable::find(const std::string& name) const
{
  return std::find_if(keywords_.begin(), keywords_.end(),
                      [&](const Keyword& k) { return k.name == name; });
}

Options KeywordTable::read(const std::vector<std::string>& words) const
{
  Options options;
  for (const Keyword& keyword : keywords_) options.keywords_.push_back(keyword.name);
  std::size_t next = 0;
  // A missing value swallows the keyword that follows: allowed, as IDs may be named like keywords,
  // but the likely reason when the word after it is unknown.
  std::string doubt;
  while (next < words.size()) {
    const std::string& name = words[next++];
    const auto keyword = find(name);
    if (keyword == keywords_.end())
      throw InputError("unknown keyword '" + name + "', expected one of: " + names() + doubt);
    if (options.has(name) && !keyword->repeats)
      throw InputError("keyword '" + name + "' stands twice, write it once");
    const std::size_t wanted = keyword->values;
    if (words.size() - next < wanted)
      throw InputError("keyword '" + name + "' takes " + std::to_string(wanted) +
                       (wanted == 1 ? " value" : " values") + ", found " +
                       std::to_string(words.size() - next) +
                       ", add what is missing: " + keyword->meaning);
    const auto first = words.begin() + static_cast<long>(next);
    options.found_[name].emplace_back(first, first + static_cast<long>(wanted));
    next += wanted;
    doubt = wanted > 0 && find(words[next - 1]) != keywords_.end()
                ? "; or '" + name + "' lacks a value, its last is '" + words[next - 1] + "'"
                : "";
  }
  return options;
}

Options KeywordTable::read(int narg, char** arg, int skip) const
{
  return read(std::vector<std::string>(arg + std::min(skip, narg), arg + narg));
}

}  // namespace encased_column
