// SPDX-License-Identifier: GPL-2.0-only
#include "shell/cylinder_mesh.h"

#include "core/constants.h"
#include "core/input_error.h"
#include "specimen/ring_mesh.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace encased_column {

namespace {

void require_positive(const char* what, double found)
{
  if (!(found > 0.0))
    throw InputError(std::string(what) + " of the sleeve must be larger than 0, found " +
                     in_words(found) + ": write a length in m");
}

}  // namespace

CylinderCounts cylinder_counts(const TubeShape& shape)
{
  require_positive("radius", shape.radius);
  require_positive("height", shape.height);
  require_positive("edge", shape.edge);
  if (shape.edge > shape.radius)
    throw InputError("edge of the sleeve must not exceed its radius " + in_words(shape.radius) +
                     " m, found " + in_words(shape.edge) + ": write a shorter edge");
  const double row = shape.edge * std::sqrt(0.75);  // height of an equilateral facet
  const double around = std::round(2.0 * pi * shape.radius / shape.edge);
  const double rows = std::max(1.0, std::round(shape.height / row));
  if (const double facets = 2.0 * around * rows; !(facets <= static_cast<double>(most_facets)))
    throw InputError("edge of the sleeve must leave " + std::to_string(most_facets) +
                     " facets at most, found " + in_words(shape.edge) + " with " +
                     in_words(facets) + ": write a longer edge, or radius and height in m");
  return {static_cast<int>(around), 1 + static_cast<int>(rows)};
}

SurfaceMesh cylinder_mesh(const TubeShape& shape)
{
  const auto [around, rings] = cylinder_counts(shape);
  SurfaceMesh mesh = mesh_of(Rings{shape.radius, shape.bottom, shape.height, around, rings - 1,
                                   true, shape.center_x, shape.center_y});
  if (shape.facing == Facing::inward)
    for (Facet& facet : mesh.facet) std::swap(facet[1], facet[2]);
  return mesh;
}

}  // namespace encased_column
