#include "runner/deck_catalogue.h"

#include "core/input_error.h"
#include "runner/setting.h"

#include <algorithm>

namespace encased_column {

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
