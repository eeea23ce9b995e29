// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/surface_mesh.h"

namespace encased_column {

/// Rings of nodes on a cylinder about an axis along z, from the lower end to the upper.
struct Rings {
  double radius = 0.0;  ///< of the nodes [m]
  double bottom = 0.0;  ///< z of the lowest ring [m]
  double height = 0.0;  ///< from there to the highest one [m]
  int around = 0;       ///< nodes of a ring, 3 or more
  int rows = 0;         ///< of facets, one less than rings
  /// Every second ring is turned by half an edge: with rows of sqrt(3) / 2 edges facets are
  /// equilateral. Otherwise they are halves of rectangles.
  bool staggered = false;
  double center_x = 0.0;  ///< [m]
  double center_y = 0.0;  ///< [m]
};

/// The lateral surface with outward facets, open at both ends. Nodes are numbered ring by ring from
/// the bottom. The cross section of each ring is a regular polygon inside the circle.
SurfaceMesh mesh_of(const Rings& rings);

}  // namespace encased_column
