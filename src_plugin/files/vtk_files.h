// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/surface_mesh.h"

#include <array>
#include <string>
#include <vector>

namespace encased_column {

/// One grain as a file holds it; plain numbers, so that ranks can send it as bytes.
struct GrainRecord {
  int id;
  int type;
  int coordination_number;             ///< contacts of the grain, -1 where not known
  double radius;                       ///< [m]
  std::array<double, 3> position;      ///< [m]
  std::array<double, 3> displacement;  ///< [m]
  std::array<double, 3> rotation;      ///< integral of the angular velocity [rad]
  std::array<double, 3> velocity;      ///< [m/s]
  double deviatoric_strain;            ///< about the grain [-]
};

struct GrainFileOptions {
  bool compress = true;
  bool rotation = true;  ///< false: the file has no such array
  bool strain = true;    ///< the same
};

/// Writes the grains as points of a VTK XML file (.vtp), reals in single precision; false when the
/// file cannot be written. A reader never sees a part of it.
bool write_grains(const std::string& path, const std::vector<GrainRecord>& grains,
                  const GrainFileOptions& options);

/// One contact as a file holds it; plain numbers, so that ranks can send it as bytes.
struct ContactRecord {
  int first;                   ///< id of the grain
  int second;                  ///< id of the other grain, larger; 0 with a wall or sleeve
  int kind;                    ///< of what it touches: 0 grain, 1 rigid wall, 2 sleeve
  int sliding;                 ///< 1 where friction is used up
  std::array<double, 3> from;  ///< center of the grain [m]
  std::array<double, 3> to;    ///< center of the other, or the nearest point of the wall [m]
  double force;                ///< magnitude [N]
  double normal_force;         ///< [N]
  double shear_force;          ///< magnitude [N]
};

/// Writes contacts as lines of a VTK XML file (.vtp), reals in single precision; false when the
/// file cannot be written. A reader never sees a part of it.
///
/// Each line has two points of its own that both carry the force: ParaView's *Tube* takes its
/// radius from points.
bool write_contacts(const std::string& path, const std::vector<ContactRecord>& contacts);

/// Writes a table as points of a VTK XML file: each row a point at its "x [m]", "y [m]", "z [m]",
/// every other column an array of that name. False when the file cannot be written.
bool write_spheres(const std::string& path, const std::vector<std::string>& columns,
                   const std::vector<std::vector<double>>& rows);

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
