// SPDX-License-Identifier: GPL-2.0-only
#include "runner/deck.h"

#include "core/input_error.h"
#include "runner/case_record.h"
#include "runner/text_file.h"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// The value of `variable` as `given`, or else as `deck` has it; nullptr if it knows none.
const std::string* value_of(const std::string& variable, const Deck& deck, const Settings& given)
{
  const std::string* own = value_in(given, variable);
  const DeckVariable* known = deck.find(variable);
  return own || !known ? own : &known->value;
}

class DeckReader {
 public:
  DeckReader(Deck& deck, const Settings& given) : deck_(deck), given_(given) {}

  void read(const fs::path& file, int depth = 0)
  {
    std::istringstream stream(read_text_file(file, "a deck"));
    for (std::string line; std::getline(stream, line);) take(line, depth);
  }

 private:
  void take(const std::string& line, int depth)
  {
    std::istringstream words(line);
    std::string command, name, style, value;
    words >> command >> name >> style >> value;
    if (command == "variable" && style == "index" && name != "common" && name != "resume" &&
        known_.insert(name).second)
      deck_.variables.push_back(variable(name, value, line));
    if (command == "record_variables") deck_.records_variables = true;
    if (command == "include" && depth < 10) include(name, depth);
  }

  static DeckVariable variable(const std::string& name, const std::string& value,
                               const std::string& line)
  {
    static const std::regex comment(R"([^#]*#\s*(\[[^\]]*\])?\s*(.*?)\s*)");
    std::smatch found;
    if (!std::regex_match(line, found, comment)) return {name, value, "", ""};
    return {name, value, found[1], found[2]};
  }

  // Of an included file that two variables name, or one that is not known yet, the deck itself must
  // know.
  void include(const std::string& written, int depth)
  {
    static const std::regex by_variable(R"(([^$]*)\$\{(\w+)\}([^$]*))");
    std::string name = replaced(written, "${common}/", "");
    std::smatch found;
    if (std::regex_match(name, found, by_variable)) {
      const ChosenFile chosen{found[2], found[1], found[3]};
      const std::string* value = value_of(chosen.variable, deck_, given_);
      if (!value) return;
      if (name != written) deck_.chosen.push_back(chosen);
      name = chosen.name(*value);
    }
    if (name.find('$') != std::string::npos) return;
    const fs::path beside = deck_.file.parent_path() / name, shared = deck_.common / name;
    const fs::path file = fs::exists(shared) ? shared : beside;
    if (fs::is_regular_file(file)) read(file, depth + 1);
  }

  Deck& deck_;
  const Settings& given_;
  std::set<std::string> known_;
};

}  // namespace

const DeckVariable* Deck::find(const std::string& variable) const
{
  for (const DeckVariable& known : variables)
    if (known.name == variable) return &known;
  return nullptr;
}

std::vector<std::string> Deck::names() const
{
  std::vector<std::string> all;
  for (const DeckVariable& known : variables) all.push_back(known.name);
  return all;
}

std::vector<std::string> Deck::choices(const std::string& variable) const
{
  const auto choice = std::find_if(chosen.begin(), chosen.end(),
                                   [&](const ChosenFile& c) { return c.variable == variable; });
  if (choice == chosen.end()) return {};
  const std::vector<std::string> usual{"quick", "standard", "paper", "study", "laboratory"};
  const std::size_t around = choice->before.size() + choice->after.size();
  std::vector<std::string> found;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(common, failure)) {
    const std::string file = entry.path().filename();
    if (file.size() <= around) continue;
    const std::string value = file.substr(choice->before.size(), file.size() - around);
    if (file == choice->name(value)) found.push_back(value);
  }
  std::sort(found.begin(), found.end(), [&](const std::string& a, const std::string& b) {
    const auto place = [&](const std::string& value) {
      return std::find(usual.begin(), usual.end(), value) - usual.begin();
    };
    return place(a) != place(b) ? place(a) < place(b) : a < b;
  });
  return found;
}

Deck read_deck(const std::string& name, const fs::path& file, const fs::path& common,
               const Settings& given)
{
  Deck deck{name, file, common, {}, {}, false, true};
  DeckReader(deck, given).read(file);
  return deck;
}

void check_choices(const Deck& deck, const Settings& given)
{
  for (const ChosenFile& choice : deck.chosen) {
    const std::string& value = *value_of(choice.variable, deck, given);
    const std::vector<std::string> known = deck.choices(choice.variable);
    if (std::find(known.begin(), known.end(), value) == known.end()) {
      if (known.empty()) continue;  // its files lie beside the deck
      throw InputError("unknown " + choice.variable + " '" + value.substr(0, 200) +
                       "', expected one of: " + joined(known));
    }
    if (fs::is_regular_file(deck.common / choice.name(value))) continue;
    throw InputError("deck " + deck.name + " must find each file of " + choice.variable + " '" +
                     value + "' in '" + shown(deck.common) + "', found no '" + choice.name(value) +
                     "', write it with the variables of '" + choice.name(known.front()) + "'");
  }
}

std::vector<std::string> DeckCatalogue::names() const
{
  std::vector<std::string> found;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(inputs_, failure)) {
    const std::string name = entry.path().filename();
    if (fs::is_regular_file(entry.path() / (name + ".lmp"))) found.push_back(name);
  }
  std::sort(found.begin(), found.end());
  return found;
}

const Deck& DeckCatalogue::find(const std::string& name, const fs::path& folder,
                                const std::string& where)
{
  fs::path file = inputs_ / name / (name + ".lmp");
  fs::path common = inputs_ / "common";
  const bool ours = is_folder_name(name) && fs::is_regular_file(file);
  if (!ours) {
    file = fs::absolute(folder / name).lexically_normal();
    if (!fs::is_regular_file(file) || !is_folder_name(file.stem()))
      throw InputError(where + " must be one of " + joined(names()) +
                       " or the file of your own deck, found '" + name.substr(0, 200) +
                       "', check its name");
    if (fs::is_directory(file.parent_path() / "common")) common = file.parent_path() / "common";
  }
  const auto known = decks_.find({file, {}});
  if (known != decks_.end()) return known->second;
  Deck deck = read_deck(file.stem(), file, common);
  deck.ours = ours;
  return decks_.emplace(std::pair(file, Settings()), std::move(deck)).first->second;
}

const Deck& DeckCatalogue::with(const Deck& deck, const Settings& given)
{
  Settings choosing;
  for (const Setting& setting : given)
    if (!deck.choices(setting.first).empty()) choosing.push_back(setting);
  const auto known = decks_.find({deck.file, choosing});
  if (known != decks_.end()) return known->second;
  Deck other = read_deck(deck.name, deck.file, deck.common, choosing);
  other.ours = deck.ours;
  return decks_.emplace(std::pair(deck.file, choosing), std::move(other)).first->second;
}

}  // namespace encased_column
