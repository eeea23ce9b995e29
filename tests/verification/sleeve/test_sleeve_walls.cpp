// SPDX-License-Identifier: GPL-2.0-only
// A sleeve and the walls beside it, through the deck.
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column::testing;

namespace {

/// A grain of 10 mm that overlaps a sleeve which stands still, and more lines.
Outcome grain_on_sleeve(const std::string& lines)
{
  return run_deck(opening_deck("empty_cylinder") +
                  "create_atoms 1 single 0 0.0455 0.1 units box\n"
                  "set group all diameter 0.01 density 2500\n"
                  "fix side all mesh/surface/shell cylinder 0.05 0 0.2 edge 0.01 type 2 platens "
                  "top bottom modulus 11.5e6 poisson 0.3 thickness 0.01 density 30 rigid yes\n"
                  "fix top all servo/platen position top z 0.2 side side type 2\n"
                  "fix bottom all servo/platen position bottom z 0 side side type 2\n"
                  "fix move all motion step 1.0\n" +
                  lines + "variable force equal fy[1]\nprint \"force ${force}\"\n");
}

}  // namespace

// Not twice as much, though the wall and the sleeve both see to the contact.
TEST(SleeveWalls, AWallOfTheHostTakesTheSleeveAsAMesh)
{
  const Outcome alone = grain_on_sleeve("run 0\n");
  const Outcome walled = grain_on_sleeve(
      "fix wall all wall/gran model linear tangential history mesh n_meshes 1 meshes side\nrun "
      "0\n");
  ASSERT_EQ(alone.exit_code, 0) << alone.output;
  ASSERT_EQ(walled.exit_code, 0) << walled.output;
  EXPECT_LT(alone.value("force"), -10.0);
  EXPECT_EQ(walled.value("force"), alone.value("force"));
}

TEST(SleeveWalls, AWallOfTheHostTakesTheSleeveBesideItsOwnMeshes)
{
  const std::string far =
      "create_wall_mesh file far.stl shape square half_width 0.05 z 0.1049 edge 0.05\n"
      "fix far all mesh/surface file far.stl type 2\n"
      "fix wall all wall/gran model linear tangential history mesh n_meshes 2 meshes ";
  const Outcome alone = grain_on_sleeve("run 0\n");
  const Outcome both =
      grain_on_sleeve(far + "side far\nrun 0\n" + "variable up equal fz[1]\nprint \"up ${up}\"\n");
  ASSERT_EQ(both.exit_code, 0) << both.output;
  EXPECT_EQ(both.value("force"), alone.value("force"));
  EXPECT_NEAR(both.value("up"), -std::acos(-1.0) * 0.005 * 7e6 * 1e-4,
              1e-6);  // pi r E* d of the mesh
}

TEST(SleeveWalls, APlatenBeyondTheEndIsWarnedOfOnce)
{
  const Outcome outcome = grain_on_sleeve("fix_modify top velocity -1e-6\nrun 1000\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const std::string sentence = "m beyond the end of sleeve 'side' at step 200, grains can escape";
  EXPECT_TRUE(outcome.says("platen 'top' stands ")) << outcome.output;
  EXPECT_TRUE(outcome.says(sentence)) << outcome.output;
  EXPECT_EQ(outcome.output.find("beyond the end", outcome.output.find("beyond the end") + 1),
            std::string::npos);
}

TEST(SleeveWalls, APlatenInsideTheSleeveIsNot)
{
  const Outcome outcome = grain_on_sleeve("fix_modify top velocity 1e-6\nrun 1000\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_FALSE(outcome.says("beyond the end"));
}

// A dump that names no mesh takes all the host thinks are meshes: a sleeve is none to it.
TEST(SleeveWalls, ADumpOfAllMeshesOfTheHostLeavesTheSleeveOut)
{
  const Outcome outcome = grain_on_sleeve(
      "create_wall_mesh file far.stl shape square half_width 0.05 z 0.1049 edge 0.05\n"
      "fix far all mesh/surface file far.stl type 2\n"
      "fix wall all wall/gran model linear tangential history mesh n_meshes 1 meshes far\n"
      "dump meshes all mesh/stl 1 meshes*.stl\nrun 1\n"
      "shell grep -c facet.normal meshes0.stl > facets.txt\n"
      "variable facets file facets.txt\nprint \"facets ${facets}\"\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(outcome.value("facets"), 8.0);  // two by two squares, halved
}
