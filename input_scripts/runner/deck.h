#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace encased_column {

/// One variable a deck offers: a line `variable NAME index VALUE # [unit] meaning`.
struct DeckVariable {
  std::string name;
  std::string value;    ///< as written: another variable may stand in it, ${modulus}
  std::string unit;     ///< with its brackets, "[Pa]"; empty without
  std::string meaning;  ///< empty if the deck does not say
};

/// A deck as it can be read without running it.
struct Deck {
  std::string name;
  std::filesystem::path file;           ///< of the deck itself
  std::filesystem::path common;         ///< folder of the files it includes from ${common}
  std::vector<DeckVariable> variables;  ///< without `common` and `resume`, which are the runner's
  bool records_variables = false;       ///< it says which variables it used
  bool ours = true;                     ///< else a user's: what lies beside it belongs to it

  const DeckVariable* find(const std::string& variable) const;
  std::vector<std::string> names() const;
  /// The resolutions that lie in `common` (resolution_R.lmp), coarse before fine.
  std::vector<std::string> resolutions() const;
};

/// Reads `file` and what it includes. Throws InputError for a file that cannot be read.
Deck read_deck(const std::string& name, const std::filesystem::path& file,
               const std::filesystem::path& common);

/// Our decks by their names, and others by their paths; each is read once.
class DeckCatalogue {
 public:
  /// `inputs` holds common/ and a folder NAME with NAME.lmp for each of our decks.
  explicit DeckCatalogue(std::filesystem::path inputs) : inputs_(std::move(inputs)) {}

  std::vector<std::string> names() const;  ///< of our decks, sorted
  /// The deck called `name`, or the one in the file `name`, a path from `folder`. Throws
  /// InputError, with `where` as the place, if there is neither.
  const Deck& find(const std::string& name, const std::filesystem::path& folder,
                   const std::string& where);

 private:
  std::filesystem::path inputs_;
  std::map<std::filesystem::path, Deck> decks_;
};

}  // namespace encased_column
