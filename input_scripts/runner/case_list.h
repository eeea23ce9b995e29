// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/case_folder.h"
#include "runner/deck.h"
#include "runner/run_options.h"
#include "runner/series.h"

#include <ostream>
#include <vector>

namespace encased_column {

/// The cases of our series.csv and of --cases.
struct Catalogue {
  std::vector<Case> ours, theirs;
  std::vector<Case> all() const { return together(ours, theirs); }
};
Catalogue read_catalogue(const Places& places, const RunOptions& options);

/// The cases that `options` choose, each once, with decks and variables checked. Throws InputError.
std::vector<CasePlan> chosen_cases(const Catalogue& catalogue, DeckCatalogue& decks,
                                   const RunOptions& options);

/// The value of the variable `name` of `deck`: "0.38", or "study 0.8, laboratory 0.38" where the
/// sets of parameters differ.
std::string values_by_set(DeckCatalogue& decks, const Deck& deck, const std::string& name);

/// What --list shows.
void list_cases(std::ostream& out, const Catalogue& catalogue, DeckCatalogue& decks,
                const RunOptions& options);

}  // namespace encased_column
