#pragma once

#include "style_table.h"

#include <string>

namespace encased_column {

/// Stands for a `fix wall/gran ... meshes` whose meshes are sleeves. A sleeve makes its contacts
/// itself (the host's would not do, see the page of fix mesh/surface/shell), so there is nothing
/// left to do but to see that the deck means the same law.
class FixWallOfSleeves : public LAMMPS_NS::Fix {
 public:
  FixWallOfSleeves(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg, const std::string& model);

  int setmask() override { return 0; }
  void init() override;

 private:
  std::string model_;  ///< the words of `model`
};

/// Makes the `fix wall/gran` of a deck, by `host` where no sleeve is among its meshes. The host
/// would take anything called mesh/surface... for a mesh of its own.
LAMMPS_NS::Fix* make_wall(FixCreator host, LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

}  // namespace encased_column
