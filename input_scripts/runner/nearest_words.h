// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace encased_column {

/// How many letters must be put in, left out, changed or swapped with their neighbour to make `b`
/// of `a`, no letter twice.
///
/// Source: optimal string alignment, L. Boytsov, "Indexing methods for approximate dictionary
/// searching", J. Exp. Algorithmics 16 (2011), section 2.
std::size_t letters_apart(const std::string& a, const std::string& b);

/// Those of `known` that a user may have meant by `word`, the nearest first, three at most: a third
/// of its letters apart at most, or one a part of the other (three letters at least).
std::vector<std::string> nearest_words(const std::string& word,
                                       const std::vector<std::string>& known);

/// ", nearest is 'radius'", ", nearest are 'from' and 'form'"; empty where there is none.
std::string nearest_clause(const std::string& word, const std::vector<std::string>& known);

}  // namespace encased_column
