// SPDX-License-Identifier: GPL-2.0-only
#include "runner/case_list.h"

#include "core/input_error.h"
#include "runner/case_variables.h"
#include "runner/nearest_words.h"
#include "runner/text_file.h"

#include <algorithm>
#include <iomanip>
#include <set>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> ids_of(const std::vector<Case>& cases)
{
  std::vector<std::string> ids;
  for (const Case& one : cases) ids.push_back(one.id);
  return ids;
}

std::vector<Case> marked(const std::vector<Case>& cases)
{
  std::vector<Case> found;
  for (const Case& one : cases)
    if (one.by_default) found.push_back(one);
  return found;
}

const Case& case_called(const std::string& id, const std::vector<Case>& cases)
{
  for (const Case& one : cases)
    if (one.id == id) return one;
  const std::vector<std::string> known = ids_of(cases);
  const std::string nearest = nearest_clause(id, known);
  throw InputError(
      "unknown case '" + id + "'" +
      (nearest.empty() ? ", expected one of: " + joined(known) : nearest + ", see --list"));
}

/// A case of the deck's name with its defaults.
Case case_of_deck(const fs::path& deck)
{
  const std::string name = deck.stem();
  if (!is_folder_name(name))
    throw InputError(
        "--deck takes a file whose name has letters, digits, '_', '-' and '.', found '" +
        deck.string() + "', rename it, for example to 'trial.lmp'");
  return {name, deck.string(), true, {}, name, ""};
}

std::vector<Case> chosen_rows(const Catalogue& catalogue, const RunOptions& options)
{
  if (options.is_series())
    return cases_of_series(options.series,
                           catalogue.theirs.empty() ? catalogue.ours : catalogue.theirs);
  if (!options.cases.empty()) {
    std::vector<Case> chosen;
    for (const std::string& id : options.cases) chosen.push_back(case_called(id, catalogue.all()));
    return chosen;
  }
  if (!catalogue.theirs.empty()) {
    const std::vector<Case> some = marked(catalogue.theirs);
    return some.empty() ? catalogue.theirs : some;
  }
  if (!options.deck.empty()) return {case_of_deck(options.deck)};
  return marked(catalogue.ours);
}

bool is_among(const std::vector<Case>& cases, const std::string& id)
{
  return std::any_of(cases.begin(), cases.end(), [&](const Case& one) { return one.id == id; });
}

/// The value of `name` in `deck`, for reading.
std::string listed_value(const Deck& deck, const std::string& name)
{
  const DeckVariable* variable = deck.find(name);
  if (!variable) return "-";
  const std::string& value = variable->value;
  const std::string in_common = "${common}/";
  if (value.rfind(in_common, 0) == 0) return "common/" + value.substr(in_common.size());
  if (value.rfind("${", 0) == 0 && value.back() == '}')
    return "as " + value.substr(2, value.size() - 3);
  return value;
}

/// `deck` with each of its sets of parameters; itself where it has none.
std::vector<const Deck*> by_set(DeckCatalogue& decks, const Deck& deck)
{
  std::vector<const Deck*> columns;
  for (const std::string& set : deck.choices("parameters"))
    columns.push_back(&decks.with(deck, {{"parameters", set}}));
  if (columns.empty()) columns.push_back(&deck);
  return columns;
}

/// The value of `name` in each of `columns`; one alone where it is the same in all.
std::vector<std::string> listed_values(const std::vector<const Deck*>& columns,
                                       const std::string& name)
{
  std::vector<std::string> values;
  for (const Deck* column : columns) values.push_back(listed_value(*column, name));
  if (std::count(values.begin(), values.end(), values.front()) == static_cast<long>(values.size()))
    values.resize(1);
  return values;
}

/// One row a variable; where the sets of parameters differ, each has its value.
void list_variables(std::ostream& out, const Deck& deck, DeckCatalogue& decks)
{
  const std::vector<std::string> sets = deck.choices("parameters");
  out << "\nVariables of " << deck.name << ", for --set NAME=VALUE (default, unit, meaning"
      << (sets.empty() ? "" : "; where they differ, by the set of parameters") << "):\n";
  const std::vector<const Deck*> columns = by_set(decks, deck);
  const auto write_row = [&](const std::string& name, const std::vector<std::string>& values,
                             const std::string& unit, const std::string& meaning) {
    out << "  " << std::left << std::setw(18) << name;
    for (const std::string& value : values) out << ' ' << std::setw(13) << value;
    out << ' ' << std::setw(13) << unit << ' ' << meaning << '\n';
  };
  if (!sets.empty()) write_row("variable", sets, "unit", "meaning");
  for (const DeckVariable& variable : deck.variables) {
    std::vector<std::string> values = listed_values(columns, variable.name);
    values.resize(columns.size());
    write_row(variable.name, values, variable.unit, variable.meaning);
  }
}

}  // namespace

std::string values_by_set(DeckCatalogue& decks, const Deck& deck, const std::string& name)
{
  const std::vector<std::string> sets = deck.choices("parameters");
  const std::vector<std::string> values = listed_values(by_set(decks, deck), name);
  if (values.size() == 1) return values.front();
  std::string text;
  for (std::size_t n = 0; n < values.size(); ++n)
    text += (n ? ", " : "") + sets[n] + " " + values[n];
  return text;
}

Catalogue read_catalogue(const Places& places, const RunOptions& options)
{
  Catalogue catalogue;
  catalogue.ours = read_series(places.inputs / "series.csv", "series.csv");
  if (!options.cases_file.empty())
    catalogue.theirs = read_series(options.cases_file, options.cases_file.string());
  catalogue.all();  // no id twice
  return catalogue;
}

std::vector<CasePlan> chosen_cases(const Catalogue& catalogue, DeckCatalogue& decks,
                                   const RunOptions& options)
{
  std::vector<CasePlan> plans;
  std::set<std::string> known;
  for (const Case& row : chosen_rows(catalogue, options)) {
    if (!known.insert(row.id).second) continue;
    const bool in_theirs = is_among(catalogue.theirs, row.id);
    const fs::path folder = in_theirs ? options.cases_file.parent_path() : fs::path();
    const Deck& deck =
        options.deck.empty()
            ? decks.find(row.deck, folder,
                         "'deck' of case '" + row.id + "' in '" +
                             (in_theirs ? options.cases_file.string() : "series.csv") + "'")
            : decks.find(fs::absolute(options.deck).string(), "", "--deck");
    if (!deck.records_variables)
      throw InputError("a deck must say which variables it uses, found no 'record_variables' in '" +
                       shown(deck.file) +
                       "', write 'record_variables file variables.csv' behind its last variable");
    const Settings given = given_variables(row.variables, options.resolution, options.settings());
    check_choices(deck, given);
    const Deck& own = decks.with(deck, given);
    check_names(own, given);
    const Settings placed = with_found_tables(own, given);
    plans.push_back({row, &own, placed, asked_variables(own, placed)});
  }
  return plans;
}

void list_cases(std::ostream& out, const Catalogue& catalogue, DeckCatalogue& decks,
                const RunOptions& options)
{
  out << "Cases (* run by default):\n";
  for (const Case& one : catalogue.all())
    out << (one.by_default ? '*' : ' ') << ' ' << std::left << std::setw(18) << one.id << ' '
        << std::setw(50) << one.title
        << (one.reproduces.empty() ? "" : " reproduces " + one.reproduces) << '\n';
  out << "\nSeries, for --series NAME: " << every_series << ' '
      << joined(series_names(catalogue.all())) << '\n';
  std::vector<const Deck*> shown_decks;
  for (const std::string& name : decks.names())
    shown_decks.push_back(&decks.find(name, "", "deck"));
  if (!options.deck.empty())
    shown_decks.push_back(&decks.find(fs::absolute(options.deck).string(), "", "--deck"));
  for (const Deck* deck : shown_decks) list_variables(out, *deck, decks);
}

}  // namespace encased_column
