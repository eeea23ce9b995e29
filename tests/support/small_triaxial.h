// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "support/child_program.h"

#include <filesystem>

namespace encased_column::testing {

/// Runs the whole deck of the plain triaxial test at 50 kPa with about a hundred grains, of 10 mm
/// and more, in a specimen of 60 mm x 60 mm, to 2 % strain, in `folder`, with the parameters of the
/// study: a second of work.
Outcome run_small_triaxial(const std::filesystem::path& folder, int ranks);
/// The same with `deck` in place of plain_triaxial_deck().
Outcome run_small_triaxial(const std::filesystem::path& folder, int ranks, const std::string& deck);

/// Copies the common files of the decks into `folder`/common, with a resolution `small` of a few
/// grains.
void prepare_small_resolution(const std::filesystem::path& folder);

/// Puts what the small test includes into `folder` and returns its variables as arguments of the
/// program.
std::vector<std::string> prepare_small_triaxial(const std::filesystem::path& folder);

/// The text of a deck.
std::string plain_triaxial_deck();
std::string encased_triaxial_deck();

}  // namespace encased_column::testing
