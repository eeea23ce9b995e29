// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/surface_mesh.h"

namespace encased_column {

/// Lateral surface of an upright cylinder around the z axis, open at both ends.
struct CylinderWall {
  double radius;  ///< [m]
  double z_low;   ///< [m]
  double z_high;  ///< [m]
  double edge;    ///< wanted length of the upright and level edges [m]
};

/// Level square around the z axis.
struct SquareWall {
  double half_width;  ///< [m]
  double z;           ///< [m]
  double edge;        ///< wanted length of the edges along x and y [m]
};

/// Rings of flat rectangles, each cut into two triangles, all nodes on the radius, normals away
/// from the axis. The counts around and along are rounded, so true edges differ a little from the
/// wanted ones. The cross section is a regular polygon inside the circle.
/// Throws InputError for a radius or edge that is not positive, for z_high <= z_low, and for edges
/// longer than the radius (fewer than six sides) or the height.
SurfaceMesh cylinder_mesh(const CylinderWall& wall);

/// Square cells, each cut into two triangles, normals along +z.
/// Throws InputError for a half width or edge that is not positive and for edges longer than the
/// square.
SurfaceMesh square_mesh(const SquareWall& wall);

}  // namespace encased_column
