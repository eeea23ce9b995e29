#pragma once

#include <filesystem>
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

}  // namespace encased_column
