// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/surface_mesh.h"

namespace encased_column {

/// Joins corners that lie within `tolerance` [m] of each other in each coordinate: triangles read
/// one by one (STL) become a mesh whose facets share their nodes. Nodes keep the order of their
/// first appearance.
SurfaceMesh welded(const std::vector<std::array<Vec3, 3>>& triangle, double tolerance);

/// The same with a tolerance of a millionth of the extent: for corners of single precision.
SurfaceMesh welded(const std::vector<std::array<Vec3, 3>>& triangle);

/// Closed chains of border edges (edges with one facet only), each as its node numbers in order.
/// Throws InputError if an edge has more than two facets, if neighbours disagree on their
/// orientation (one of them is inverted), if a facet names a node twice or has no area, or if a
/// node belongs to no facet.
std::vector<std::vector<int>> border_loops(const SurfaceMesh& mesh);

/// Facets that share an edge, each pair once.
std::vector<std::array<int, 2>> facet_pairs(const SurfaceMesh& mesh);

/// Refuses what is not the lateral surface of a sleeve: a mesh with other than two borders (its two
/// ends) has a hole or is closed. Throws InputError, as border_loops does.
void require_sleeve(const SurfaceMesh& mesh);

}  // namespace encased_column
