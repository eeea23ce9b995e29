#pragma once

#include "core/vec3.h"

#include <array>
#include <vector>

namespace encased_column {

using Facet = std::array<int, 3>;

/// A triangulated surface; the normal of a facet is (x1 - x0) x (x2 - x0).
struct SurfaceMesh {
  std::vector<Vec3> node;    ///< [m]
  std::vector<Facet> facet;  ///< node numbers
};

}  // namespace encased_column
