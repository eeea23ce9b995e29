// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/case_run.h"

#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// One variable of a deck as a run took it.
struct DeckInput {
  std::string name;
  std::string value;    ///< as given, variables it refers to put in
  std::string unit;     ///< "-" without one
  std::string meaning;  ///< "-" if the deck does not say
};

/// The variables of `run`, with unit and meaning from the comments of the deck in its folder
/// (`variable radius index 0.05  # [m] of the specimen`).
std::vector<DeckInput> deck_inputs(const CaseRun& run);

/// The number that the deck in the folder of `run`, with the set of parameters that it used, has
/// for the variable `name` by itself; nothing where there is none.
std::optional<double> usual_value(const CaseRun& run, const std::string& name);

}  // namespace encased_column
