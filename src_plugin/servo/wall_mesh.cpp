// SPDX-License-Identifier: GPL-2.0-only
#include "servo/wall_mesh.h"

#include "core/constants.h"
#include "core/input_error.h"
#include "specimen/ring_mesh.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

namespace {

void require_positive(const std::string& keyword, double value)
{
  if (!(value > 0.0))
    throw InputError("'" + keyword + "' must be larger than zero, found " + in_words(value) +
                     ", write a length in m");
}

void require_edge_within(double edge, double longest, const std::string& of_what)
{
  require_positive("edge", edge);
  if (edge > longest)
    throw InputError("'edge' must not be longer than the " + of_what + ", " + in_words(longest) +
                     ", found " + in_words(edge) + ", write a shorter one");
  // 4 million triangles: more is a slip of units, not a wish
  if (longest / edge > 1000.0)
    throw InputError("'edge' must be at least a thousandth of the " + of_what + ", " +
                     in_words(longest) + ", found " + in_words(edge) + ", write a longer one");
}

int nearest_count(double length, double edge)
{
  return std::max(1, static_cast<int>(std::lround(length / edge)));
}

/// Two triangles for a cell with corners a (low left), b (low right), c (high right), d (high
/// left).
void add_cell(SurfaceMesh& mesh, int a, int b, int c, int d)
{
  mesh.facet.push_back({a, b, c});
  mesh.facet.push_back({a, c, d});
}

}  // namespace

SurfaceMesh cylinder_mesh(const CylinderWall& wall)
{
  require_positive("radius", wall.radius);
  if (!(wall.z_high > wall.z_low))
    throw InputError("'z_high' must be larger than 'z_low', " + in_words(wall.z_low) + ", found " +
                     in_words(wall.z_high) + ", write a larger one");
  const double height = wall.z_high - wall.z_low;
  require_edge_within(wall.edge, wall.radius, "radius");
  require_edge_within(wall.edge, height, "height");

  const int around = nearest_count(2.0 * pi * wall.radius, wall.edge);
  const int along = nearest_count(height, wall.edge);
  SurfaceMesh mesh = mesh_of(Rings{wall.radius, wall.z_low, height, around, along});
  // the last ring lies exactly on z_high, whatever the rounding
  for (auto node = mesh.node.end() - around; node != mesh.node.end(); ++node)
    node->z() = wall.z_high;
  return mesh;
}

SurfaceMesh square_mesh(const SquareWall& wall)
{
  require_positive("half_width", wall.half_width);
  const double width = 2.0 * wall.half_width;
  require_edge_within(wall.edge, width, "square's width");

  const int cells = nearest_count(width, wall.edge);
  const auto place = [&](int k) { return wall.half_width * (2.0 * k / cells - 1.0); };
  SurfaceMesh mesh;
  for (int row = 0; row <= cells; ++row)
    for (int column = 0; column <= cells; ++column)
      mesh.node.emplace_back(place(column), place(row), wall.z);
  const int stride = cells + 1;
  for (int row = 0; row < cells; ++row)
    for (int column = 0; column < cells; ++column) {
      const int corner = row * stride + column;
      add_cell(mesh, corner, corner + 1, corner + 1 + stride, corner + stride);
    }
  return mesh;
}

}  // namespace encased_column
