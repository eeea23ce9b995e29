// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/case_record.h"

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

/// A file that a deck includes by the value of a variable: resolution_${resolution}.lmp.
struct ChosenFile {
  std::string variable;       ///< "resolution"
  std::string before, after;  ///< "resolution_" and ".lmp"

  std::string name(const std::string& value) const { return before + value + after; }
};

/// A deck as it can be read without running it.
struct Deck {
  std::string name;
  std::filesystem::path file;           ///< of the deck itself
  std::filesystem::path common;         ///< folder of the files it includes from ${common}
  std::vector<DeckVariable> variables;  ///< without `common` and `resume`, which are the runner's
  std::vector<ChosenFile> chosen;       ///< of `common`
  bool records_variables = false;       ///< it says which variables it used
  bool ours = true;                     ///< else a user's: what lies beside it belongs to it

  const DeckVariable* find(const std::string& variable) const;
  std::vector<std::string> names() const;
  /// The values of `variable` for which its file lies in `common`: resolutions coarse before fine,
  /// the set of the study before others. None if `variable` chooses no file.
  std::vector<std::string> choices(const std::string& variable) const;
};

/// Reads `file` and what it includes; files are chosen by the values in `given`, else by the
/// deck's own. Throws InputError for a file that cannot be read.
Deck read_deck(const std::string& name, const std::filesystem::path& file,
               const std::filesystem::path& common, const Settings& given = {});

/// Throws InputError where a variable of `deck`, with its value in `given` or else its own, chooses
/// a file that is not there.
void check_choices(const Deck& deck, const Settings& given);

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
  /// `deck` with the files that `given` chooses.
  const Deck& with(const Deck& deck, const Settings& given);

 private:
  std::filesystem::path inputs_;
  std::map<std::pair<std::filesystem::path, Settings>, Deck> decks_;
};

}  // namespace encased_column
