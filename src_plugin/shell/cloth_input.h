// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "shell/shell_material.h"

namespace encased_column {

/// What a deck says of a sleeve as a cloth: strip tests, strength, seam.
const std::vector<Keyword>& cloth_keywords();

/// Throws InputError.
ClothConstants read_cloth(const Options& options);

/// Moduli [Pa] that the first rows of the strip tables stand for, where the deck gives none.
void take_moduli_of_strip(ShellConstants& constants);

}  // namespace encased_column
