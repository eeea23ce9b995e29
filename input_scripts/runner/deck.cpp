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

class DeckReader {
 public:
  explicit DeckReader(Deck& deck) : deck_(deck) {}

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

  // Of an included file whose name holds another variable than these the deck itself must know.
  void include(std::string name, int depth)
  {
    const auto common = replaced(name, "${common}/", "");
    const DeckVariable* resolution = deck_.find("resolution");
    name = resolution ? replaced(common, "${resolution}", resolution->value) : common;
    if (name.find('$') != std::string::npos) return;
    const fs::path beside = deck_.file.parent_path() / name, shared = deck_.common / name;
    const bool is_common = common.size() != name.size() || fs::exists(shared);
    const fs::path file = is_common && fs::exists(shared) ? shared : beside;
    if (fs::is_regular_file(file)) read(file, depth + 1);
  }

  Deck& deck_;
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

std::vector<std::string> Deck::resolutions() const
{
  const std::vector<std::string> usual{"quick", "standard", "paper"};
  std::vector<std::string> found;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(common, failure)) {
    const std::string stem = entry.path().stem();
    if (stem.rfind("resolution_", 0) == 0) found.push_back(stem.substr(11));
  }
  std::sort(found.begin(), found.end(), [&](const std::string& a, const std::string& b) {
    const auto place = [&](const std::string& r) {
      return std::find(usual.begin(), usual.end(), r) - usual.begin();
    };
    return place(a) != place(b) ? place(a) < place(b) : a < b;
  });
  return found;
}

Deck read_deck(const std::string& name, const fs::path& file, const fs::path& common)
{
  Deck deck{name, file, common, {}, false, true};
  DeckReader(deck).read(file);
  return deck;
}

namespace fs = std::filesystem;

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
  const auto known = decks_.find(file);
  if (known != decks_.end()) return known->second;
  Deck& deck = decks_.emplace(file, read_deck(file.stem(), file, common)).first->second;
  deck.ours = ours;
  return deck;
}

}  // namespace encased_column
