// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/shell_support.h"

#include <string>
#include <vector>

namespace encased_column {

/// How an end of a sleeve is held.
enum class SleeveEnd { held, clamped, radial, platen, free };

/// Their names in a deck, in the order of the enumeration.
inline const std::vector<std::string>& sleeve_end_names()
{
  static const std::vector<std::string> names{"held", "clamped", "radial", "platen", "free"};
  return names;
}

inline SleeveEnd sleeve_end_of(const std::string& name)
{
  const auto& names = sleeve_end_names();
  for (std::size_t n = 0; n < names.size(); ++n)
    if (names[n] == name) return static_cast<SleeveEnd>(n);
  return SleeveEnd::held;
}

/// Adds the supports of an end's nodes; `axis` is the unit vector along the sleeve. An end that
/// follows a platen is held, and moved by setting the velocity of its supports.
inline void add_supports(SleeveEnd end, const std::vector<int>& nodes, const Vec3& axis,
                         std::vector<Support>& supports)
{
  for (const int node : nodes) switch (end) {
      case SleeveEnd::held:
      case SleeveEnd::platen:
        supports.push_back(held(node));
        break;
      case SleeveEnd::clamped:
        supports.push_back(clamped(node));
        break;
      case SleeveEnd::radial:
        supports.push_back(held_across(node, axis));
        break;
      case SleeveEnd::free:
        break;
    }
}

}  // namespace encased_column
