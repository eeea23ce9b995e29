#include "runner/case_list.h"

#include "core/input_error.h"
#include "runner/case_variables.h"
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
  throw InputError("unknown case '" + id + "', expected one of: " + joined(ids_of(cases)));
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

void check_resolution(const Deck& deck, const Settings& asked)
{
  const std::vector<std::string> known = deck.resolutions();
  for (const auto& [name, value] : asked)
    if (name == "resolution" && !known.empty() &&
        std::find(known.begin(), known.end(), value) == known.end())
      throw InputError("unknown resolution '" + value + "', expected one of: " + joined(known));
}

bool is_among(const std::vector<Case>& cases, const std::string& id)
{
  return std::any_of(cases.begin(), cases.end(), [&](const Case& one) { return one.id == id; });
}

void list_variables(std::ostream& out, const Deck& deck)
{
  for (const DeckVariable& variable : deck.variables) {
    std::string value = variable.value;
    if (value.rfind("${", 0) == 0 && value.back() == '}')
      value = "as " + value.substr(2, value.size() - 3);
    out << "  " << std::left << std::setw(18) << variable.name << ' ' << std::setw(14) << value
        << ' ' << std::setw(13) << variable.unit << ' ' << variable.meaning << '\n';
  }
}

}  // namespace

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
    CasePlan plan{row,
                  &deck,
                  given_variables(deck, row.variables, options.resolution, options.settings()),
                  {}};
    plan.asked = asked_variables(deck, plan.given);
    check_resolution(deck, plan.asked);
    plans.push_back(std::move(plan));
  }
  return plans;
}

void list_cases(std::ostream& out, const Catalogue& catalogue, DeckCatalogue& decks,
                const RunOptions& options)
{
  out << "Cases (* run by default):\n";
  for (const Case& one : catalogue.all())
    out << (one.by_default ? '*' : ' ') << ' ' << std::left << std::setw(16) << one.id << ' '
        << std::setw(36) << one.title
        << (one.reproduces.empty() ? "" : " reproduces " + one.reproduces) << '\n';
  out << "\nSeries, for --series NAME: " << every_series << ' '
      << joined(series_names(catalogue.all())) << '\n';
  std::vector<const Deck*> shown_decks;
  for (const std::string& name : decks.names())
    shown_decks.push_back(&decks.find(name, "", "deck"));
  if (!options.deck.empty())
    shown_decks.push_back(&decks.find(fs::absolute(options.deck).string(), "", "--deck"));
  for (const Deck* deck : shown_decks) {
    out << "\nVariables of " << deck->name << ", for --set NAME=VALUE (default, unit, meaning):\n";
    list_variables(out, *deck);
  }
}

}  // namespace encased_column
