// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "host/host_types.h"

namespace encased_column {

/// Stands for a `fix wall/gran ... meshes` all of whose meshes are sleeves. A sleeve makes its
/// contacts itself (the host's would not do, see the page of fix mesh/surface/shell): there is
/// nothing left to do.
class FixWallOfSleeves : public LAMMPS_NS::Fix {
 public:
  using Fix::Fix;
  int setmask() override { return 0; }
};

/// Makes the `fix wall/gran` of a deck by `host`, but for the sleeves among its meshes: the host
/// would take anything called mesh/surface... for a mesh of its own. Ends with a sentence where the
/// wall means another contact law than the pairs'.
LAMMPS_NS::Fix* make_wall(FixCreator host, LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

}  // namespace encased_column
