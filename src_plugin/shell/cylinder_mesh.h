// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/surface_mesh.h"

namespace encased_column {

/// Which way the facets of a cylinder look.
enum class Facing { outward, inward };

/// A cylinder to be meshed; its axis is z.
struct TubeShape {
  double radius = 0.0;    ///< of the nodes [m]
  double bottom = 0.0;    ///< z of the lower end [m]
  double height = 0.0;    ///< [m]
  double edge = 0.0;      ///< wanted edge length [m]
  double center_x = 0.0;  ///< [m]
  double center_y = 0.0;  ///< [m]
  Facing facing = Facing::outward;
};

/// The lateral surface in staggered rings of nearly equilateral facets. Nodes are numbered ring by
/// ring from the bottom; the number of nodes per ring and of rings are the wanted edge's, rounded.
/// Throws InputError for a size that is not positive.
SurfaceMesh cylinder_mesh(const TubeShape& shape);

/// Nodes per ring and number of rings of that mesh.
struct CylinderCounts {
  int around;
  int rings;
};
CylinderCounts cylinder_counts(const TubeShape& shape);

}  // namespace encased_column
