// SPDX-License-Identifier: GPL-2.0-only
// `delete_atoms` gives the grains that stay new numbers, and their contacts keep their springs.
#include "support/child_program.h"

#include <gtest/gtest.h>

using namespace encased_column::testing;

namespace {

/// Grains 1, 2 and 3 in a row and 4 and 5 in another, neighbours pressed together by 0.2 mm. Grains
/// 3 and 5 move sideways by 10 um. Then grain 1 goes, so that 2 to 5 become 1 to 4.
const std::string rows = opening_deck("two_grains") + R"(
create_atoms   1 single 0.0396 0 0.1 units box
create_atoms   1 single 0 0 0.15 units box
create_atoms   1 single 0.0198 0 0.15 units box
set            group all diameter 0.02 density 2500
unfix          move
group          last id 3 5
group          first id 1
fix            shift last move linear 0 1 0 units box
timestep       1e-6
run            10
unfix          shift
velocity       all set 0 0 0 units box
)";

const std::string forces = R"(
compute        shear last reduce sum fy
compute        largest last reduce max fy
compute        id all property/atom id
compute        most all reduce max c_id
thermo_style   custom step atoms c_shear c_largest c_most
variable       sum equal c_shear
variable       least equal c_largest
variable       number equal atoms
variable       most equal c_most
run            0
print          "shear ${sum}"
print          "weakest ${least}"
print          "grains ${number}"
print          "highest ${most}"
)";

constexpr double stiffness = 109955.74287564278, way = 10e-6;
// The normal force, which has turned with the grains, takes a little of the spring's away.
constexpr double force = stiffness * (0.2e-3 * way / 0.0198 - way);

}  // namespace

TEST(RenumberedGrains, KeepTheSpringsOfTheirContacts)
{
  for (const std::string options : {"", " compress yes", " compress no"})
    for (const int ranks : {1, 2}) {
      const Outcome outcome =
          run_deck(rows + "delete_atoms group first" + options + "\n" + forces, ranks);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
      EXPECT_EQ(outcome.value("grains"), 4.0);
      EXPECT_EQ(outcome.value("highest"), options == " compress no" ? 5.0 : 4.0);
      EXPECT_NEAR(outcome.value("shear"), 2.0 * force, 1e-6) << options << ", ranks " << ranks;
      EXPECT_NEAR(outcome.value("weakest"), force, 1e-6) << options << ", ranks " << ranks;
    }
}

// The list of pairs has the old places of the grains when the second one goes.
TEST(RenumberedGrains, KeepTheirSpringsWhenAnotherOneGoes)
{
  for (const int ranks : {1, 2}) {
    const Outcome outcome = run_deck(
        rows + "group second id 2\ndelete_atoms group first\ndelete_atoms group second\n" + forces,
        ranks);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_EQ(outcome.value("grains"), 3.0);
    EXPECT_NEAR(outcome.value("shear"), force, 1e-6) << "ranks " << ranks;
  }
}

// The host throws away what it keeps the memories in.
TEST(RenumberedGrains, KeepTheirSpringsWhereTheListsAreGivenOtherSizes)
{
  const Outcome outcome = run_deck(rows + "neigh_modify one 400 page 4000\n" + forces);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_NEAR(outcome.value("shear"), 2.0 * force, 1e-6);
}

// Three pairs, each counted for both of its grains, from the host's rows of contacts.
TEST(RenumberedGrains, AreCountedByTheHostsComputeOfContacts)
{
  const Outcome outcome = run_deck(rows + R"(
compute        touches all contact/atom/gran
compute        touch all reduce sum c_touches
variable       touch equal c_touch
thermo_style   custom step c_touch
run            2
print          "touches ${touch}"
)");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(outcome.value("touches"), 6.0);
}

TEST(RenumberedGrains, AreNotReplicatedWithTheSpringsOfOthers)
{
  const Outcome outcome = run_deck(rows + "replicate 1 1 1 offset 0 0 0\n");
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.says("'replicate' must stand before the first run")) << outcome.output;
}
