#pragma once

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

}  // namespace encased_column
