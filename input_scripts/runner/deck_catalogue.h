#pragma once

#include "runner/deck.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace encased_column {

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
