// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <array>
#include <vector>

namespace encased_column {

using Facet = std::array<int, 3>;

/// More facets in one mesh are a slip of units, not a wish: every rank would keep half a kilobyte
/// of each.
constexpr long most_facets = 1000000;

/// A triangulated surface; the normal of a facet is (x1 - x0) x (x2 - x0).
struct SurfaceMesh {
  std::vector<Vec3> node;    ///< [m]
  std::vector<Facet> facet;  ///< node numbers
};

}  // namespace encased_column
