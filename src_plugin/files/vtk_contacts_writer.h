#pragma once

#include <array>
#include <string>
#include <vector>

namespace encased_column {

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

}  // namespace encased_column
