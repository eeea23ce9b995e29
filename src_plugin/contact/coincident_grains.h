#pragma once

#include <optional>
#include <utility>

namespace encased_column {

/// Two of `count` grains whose centers, three numbers each [m], are the same point: no direction
/// leads from one to the other, and no contact law can part them.
std::optional<std::pair<int, int>> find_coincident(const double* centers, int count);

}  // namespace encased_column
