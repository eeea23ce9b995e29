// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/places.h"

#include <string>

namespace encased_column {

/// `encase styles`: the styles of the plugin, a line each. Throws InputError where the program with
/// the plugin does not start.
int styles_command(const Places& places);

/// `encase explain WORD`: what a style, a keyword of one, a column that it writes or a variable of
/// our decks means. Throws InputError with the nearest names for a word that is none.
int explain_command(const Places& places, const std::string& word);

}  // namespace encased_column
