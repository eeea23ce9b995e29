#pragma once

#include "core/surface_mesh.h"

#include <string>
#include <vector>

namespace encased_column {

/// A quantity at each node or facet of a surface: "velocity [m/s]" with three components.
struct SurfaceField {
  std::string name;
  int components;
  std::vector<double> values;  ///< those of one place side by side
};

/// Writes a triangulated surface as a VTK XML file (.vtp), reals in single precision; false when
/// the file cannot be written. A reader never sees a part of it.
bool write_surface(const std::string& path, const std::vector<Vec3>& nodes,
                   const std::vector<Facet>& facets, const std::vector<SurfaceField>& at_nodes,
                   const std::vector<SurfaceField>& at_facets);

}  // namespace encased_column
