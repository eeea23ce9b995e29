// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "host/host_types.h"

namespace encased_column {

/// `create_wall_mesh`: writes the triangles of a cylinder or a platen into an STL file.
class CreateWallMeshCommand : protected LAMMPS_NS::Pointers {
 public:
  static const KeywordTable keywords;

  explicit CreateWallMeshCommand(LAMMPS_NS::LAMMPS* lmp) : LAMMPS_NS::Pointers(lmp) {}
  void command(int narg, char** arg);
};

}  // namespace encased_column
