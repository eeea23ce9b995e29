// SPDX-License-Identifier: GPL-2.0-only
#include "runner/series.h"

#include "core/input_error.h"
#include "runner/text_file.h"

#include <algorithm>
#include <map>
#include <set>

namespace encased_column {

namespace {

const std::vector<std::string> known_columns{"id",        "series", "deck",      "default",
                                             "variables", "title",  "reproduces"};

using Columns = std::map<std::string, std::size_t>;

Columns columns_of(const std::vector<std::string>& head, const std::string& name)
{
  Columns columns;
  for (std::size_t n = 0; n < head.size(); ++n) {
    if (std::find(known_columns.begin(), known_columns.end(), head[n]) == known_columns.end())
      throw InputError("'" + name + "' takes the columns id, series, deck, default, variables, " +
                       "title and reproduces, found '" + head[n].substr(0, 60) +
                       "', write them in its first line");
    if (!columns.emplace(head[n], n).second)
      throw InputError("'" + name + "' must name a column once, found '" + head[n] +
                       "' twice, leave one out");
  }
  for (const char* needed : {"id", "deck", "variables"})
    if (!columns.count(needed))
      throw InputError("'" + name + "' must have the column '" + needed +
                       "', found none, write for example " +
                       "'id,series,deck,default,variables,title,reproduces' as its first line");
  return columns;
}

Settings read_settings(const std::string& text, const std::string& where)
{
  Settings settings;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    const std::string one = text.substr(begin, end - begin);
    if (!one.empty()) settings.push_back(read_setting("'variables' of " + where, one));
    begin = end + 1;
  }
  return settings;
}

/// Names with ';' between them.
std::vector<std::string> read_series_names(const std::string& text, const std::string& where)
{
  std::vector<std::string> names;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ';');) {
    if (is_folder_name(word) && word != every_series) {
      names.push_back(word);
      continue;
    }
    throw InputError("'series' of " + where +
                     " takes letters, digits, '_', '-' and '.', and is not 'all', found '" +
                     word.substr(0, 60) + "', write for example 'densities' or leave it empty");
  }
  return names;
}

bool read_mark(const std::string& word, const std::string& where)
{
  if (word != "0" && word != "1" && !word.empty())
    throw InputError("'default' of " + where + " must be 0 or 1, found '" + word.substr(0, 60) +
                     "', write 1 for a case that runs without --case");
  return word == "1";
}

}  // namespace

Setting read_setting(const std::string& keyword, const std::string& text)
{
  const std::size_t sign = text.find('=');
  const std::string name = text.substr(0, sign);
  const bool is_name = !name.empty() && !std::isdigit(static_cast<unsigned char>(name.front())) &&
                       std::all_of(name.begin(), name.end(),
                                   [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  const bool is_value = sign != std::string::npos && sign + 1 < text.size() &&
                        text.find_first_of(" \t\n\r\"'$&#") == std::string::npos;
  if (!is_name || !is_value)
    throw InputError(keyword + " takes NAME=VALUE without blanks, found '" + text.substr(0, 60) +
                     "', write for example '" + (keyword == "--set" ? "--set " : "") +
                     "sigma3=50e3'");
  return {name, text.substr(sign + 1)};
}

bool is_folder_name(const std::string& word)
{
  if (word.empty() || word.size() > 200 || word.front() == '-' || word.front() == '.') return false;
  return std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return c < 0x80 && (std::isalnum(c) || c == '_' || c == '-' || c == '.');
  });
}

std::vector<Case> read_series(const std::filesystem::path& file, const std::string& name)
{
  const auto rows = csv_rows(read_text_file(file, "'" + name + "'"), name);
  if (rows.empty())
    throw InputError("'" + name + "' must have a first line with the names of its columns, found " +
                     "none, write for example 'id,series,deck,default,variables,title,reproduces'");
  const Columns columns = columns_of(rows.front(), name);
  std::vector<Case> cases;
  std::set<std::string> known;
  for (std::size_t n = 1; n < rows.size(); ++n) {
    const auto cell = [&](const char* column) {
      const auto found = columns.find(column);
      return found == columns.end() ? std::string() : rows[n][found->second];
    };
    const std::string id = cell("id");
    if (!is_folder_name(id))
      throw InputError("'id' in '" + name + "' takes letters, digits, '_', '-' and '.', found '" +
                       id.substr(0, 60) + "', write for example 'trial_2'");
    if (!known.insert(id).second)
      throw InputError("'id' in '" + name + "' must be another one in each row, found '" + id +
                       "' twice, rename one of them");
    const std::string where = "case '" + id + "' in '" + name + "'";
    if (cell("deck").empty())
      throw InputError("'deck' of " + where +
                       " must name a deck, found nothing, write for example " +
                       "'triaxial_plain' or the path of your own");
    cases.push_back({id, cell("deck"), read_mark(cell("default"), where),
                     read_settings(cell("variables"), where),
                     cell("title").empty() ? id : cell("title"), cell("reproduces"),
                     read_series_names(cell("series"), where)});
  }
  if (cases.empty())
    throw InputError("'" + name +
                     "' must have one row at least below its first line, found none, " +
                     "write one for each test");
  return cases;
}

std::vector<std::string> series_names(const std::vector<Case>& cases)
{
  std::vector<std::string> names;
  for (const Case& one : cases)
    for (const std::string& name : one.series)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

std::vector<Case> cases_of_series(const std::string& series, const std::vector<Case>& cases)
{
  if (series == every_series) return cases;
  std::vector<Case> found;
  for (const Case& one : cases)
    if (std::count(one.series.begin(), one.series.end(), series)) found.push_back(one);
  if (found.empty())
    throw InputError("unknown series '" + series + "', expected one of: " + every_series + " " +
                     joined(series_names(cases)));
  return found;
}

std::vector<Case> together(const std::vector<Case>& ours, const std::vector<Case>& theirs)
{
  std::vector<Case> all = ours;
  for (const Case& added : theirs) {
    for (const Case& known : ours)
      if (known.id == added.id)
        throw InputError("'id' in the file of --cases must be another one than those of our own " +
                         std::string("series.csv, found '") + added.id + "', rename that row");
    all.push_back(added);
  }
  return all;
}

}  // namespace encased_column
