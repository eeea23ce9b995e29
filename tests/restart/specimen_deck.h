// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "support/child_program.h"

#include <string>

namespace encased_column::testing {

// A specimen of some 230 grains, 50 mm high and wide, in the pieces a deck is made of: a run that
// goes on from a restart file reads it in place of box and grains and gives the rest again.

inline const std::string host = R"(
units          si
atom_style     granular
atom_modify    map array
boundary       f f f
newton         off
communicate    single vel yes
processors     1 1 *
)";

inline const std::string box = R"(
region         box block -0.04 0.04 -0.04 0.04 -0.005 0.06 units box
create_box     3 box
)";

inline const std::string materials_and_walls = R"(
neighbor       0.0005 bin
neigh_modify   every 1 delay 0 check yes
pair_style     gran model linear tangential history rolling_friction epsd2
pair_coeff     * *
fix            modulus all property/global contactModulus peratomtypepair 3 7e6 7e6 7e6 7e6 7e6 7e6 7e6 7e6 7e6
fix            kappa all property/global stiffnessRatio peratomtypepair 3 2 2 2 2 2 2 2 2 2
fix            friction all property/global coefficientFriction peratomtypepair 3 0.5 0.5 0.1 0.5 0 0 0.1 0 0
fix            rolling all property/global coefficientRollingFriction peratomtypepair 3 0.1 0.1 0 0.1 0 0 0 0 0
fix            side all servo/cylinder radius 0.025 platens top bottom type 3
fix            top all servo/platen position top z 0.05 side side type 2
fix            bottom all servo/platen position bottom z 0 side side type 2
)";

inline const std::string grains =
    "create_packing gradation " ENCASE_SOURCE
    "/input_scripts/common/gradation_cinder_gravel.csv distribution uniform_number finest 5e-3 "
    "cylinder 0.025 0 0.05 porosity 0.38 density 1738 type 1 seed 1 start_factor 0.5\n";

inline const std::string motion = R"(
fix            move all motion damping 0.7 step 1.0 every 50
fix            weight all gravity 9.8 vector 0 0 -1
thermo_style   custom step atoms f_move[1] f_move[4] f_move[5] f_side[1] f_side[3] f_top[1] f_bottom[1]
thermo_modify  lost error norm no flush yes
thermo         100
)";

inline const std::string growth = "fix grow all grow/radius from 0.5 stages 50 relax 20\n";

inline const std::string history =
    "fix history all specimen/history platens top bottom side side motion move every 50\n";

/// Writes the grains as they are now, every bit of them, into `file`.
inline std::string picture(const std::string& file)
{
  return "dump picture all custom 1 " + file +
         " id radius mass x y z vx vy vz omegax omegay omegaz\n"
         "dump_modify picture sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g "
         "%.17g %.17g %.17g\"\n"
         "run 0\n"
         "undump picture\n";
}

/// The whole deck of a new specimen up to `commands`.
inline std::string new_specimen(const std::string& commands)
{
  return host + box + materials_and_walls + grains + motion + growth + commands;
}

/// A deck that reads the restart file `file` and goes on with `commands`.
inline std::string specimen_of(const std::string& file, const std::string& commands)
{
  return host + "read_restart " + file + "\n" + materials_and_walls + motion + commands;
}

}  // namespace encased_column::testing
