// SPDX-License-Identifier: GPL-2.0-only
// Growth under a stress, against packings whose answer is known: a spring that jams at a volume
// which its friction sets, and gives way when that falls.
#include "packing/growth_control.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace encased_column;

namespace {

using Stage = GrowthControl::Stage;

/// Grains that bear nothing until their volume reaches `jam_without` + `for_friction` times the
/// factor on friction, and from there on a stress that rises by `stiffness` with the volume strain.
struct Packing {
  double jam_without, for_friction, stiffness;
  double contacts_say = 1.0;  ///< stiffness of the contacts over that of the packing

  double jam(double friction) const { return jam_without - for_friction * friction; }
  PackingState at(double solid, double friction) const
  {
    const double strain = solid / jam(friction) - 1.0;
    if (strain <= 0.0) return {0.0, 0.0, 0.0};
    return {stiffness * strain, contacts_say * stiffness, 0.0};
  }
};

void grow(GrowthControl& control, const Packing& packing, int looks = 100000)
{
  for (int n = 0; n < looks && control.stage() == Stage::grows; ++n)
    control.decide(packing.at(control.solid(), control.friction_factor()));
}

double stress_of(const GrowthControl& control, const Packing& packing)
{
  return packing.at(control.solid(), control.friction_factor()).mean_stress;
}

const GrowthGoal goal{5e3, 0.95, 1e-2, GrowthGoal::Until::full_size};
const GrowthGoal limits{5e3, 0.95, 1e-2, GrowthGoal::Until::limits};
/// In reach: it jams at 0.95 with all friction and at 1.05 without.
const Packing in_reach{1.05, 0.10, 5e7};

}  // namespace

// A third of the trace of the sum of force times branch: two grains of radius 1 that press with 3 N
// give 3 N x 2 m / 3 in 1 m^3.
TEST(ContactSums, GiveTheMeanStressOfLoveAndWeber)
{
  ContactSums sums;
  sums.add(1.0, 3.0, 0.0, 2.0);
  EXPECT_DOUBLE_EQ(sums.mean_stress(1.0), 2.0);
  sums.add(0.5, 3.0, 0.0, 2.0);
  EXPECT_DOUBLE_EQ(sums.mean_stress(2.0), 1.5);
}

// A cubic lattice of grains that touch along the axes, one contact per axis and cell: the stress on
// a face is k x / (2 r)^2 for the overlap x, which is a third of the volume strain times 2 r.
TEST(ContactSums, GiveTheBulkStiffnessOfACubicLattice)
{
  const double radius = 0.01, stiffness = 4e5, edge = 2.0 * radius;
  ContactSums cell;
  for (int axis = 0; axis < 3; ++axis) cell.add(1.0, 0.0, stiffness, edge);
  const double volume_strain = 1e-5, overlap = volume_strain / 3.0 * edge;
  EXPECT_DOUBLE_EQ(cell.bulk_stiffness(edge * edge * edge),
                   stiffness * overlap / (edge * edge) / volume_strain);
}

TEST(GrowthControl, GrowsInEqualPartsOfTheVolumeWhileNothingTouches)
{
  GrowthControl control(goal, 0.5, 100);
  EXPECT_DOUBLE_EQ(control.radius_factor(), 0.5);
  for (int n = 1; n <= 100; ++n) {
    control.decide({0.0, 0.0, 1.0});
    EXPECT_NEAR(control.solid(), 0.125 + 0.875 * n / 100.0, 1e-13);
  }
  EXPECT_NEAR(std::pow(control.radius_factor(), 3.0), control.solid(), 1e-14);
}

TEST(GrowthControl, EndsAtExactlyFullSizeWithNoMoreThanTheStress)
{
  GrowthControl control(goal, 0.5, 100);
  grow(control, in_reach);
  EXPECT_EQ(control.stage(), Stage::ended);
  EXPECT_EQ(control.radius_factor(), 1.0);
  EXPECT_LE(stress_of(control, in_reach), 5e3);
}

// At full size the spring bears the stress where 1.05 - 0.10 f = 1 / (1 + 5e3 / 5e7).
TEST(GrowthControl, LowersFrictionOnlyAsFarAsTheSizeAsksFor)
{
  GrowthControl control(goal, 0.5, 100);
  grow(control, in_reach);
  const double needed = (1.05 - 1.0 / (1.0 + 1e-4)) / 0.10;
  EXPECT_LE(control.friction_factor(), needed);
  EXPECT_GT(control.friction_factor(), 0.9 * needed);  // one lowering further at most
}

// Where friction was lowered no contact may be left to tell how stiff the grains are: one step of
// the largest size is what the stress can be run over by.
TEST(GrowthControl, NeverRaisesFrictionAndRunsOverTheStressByOneStepAtMost)
{
  for (const double contacts_say : {1.0, 3.0}) {
    Packing packing = in_reach;
    packing.contacts_say = contacts_say;
    GrowthControl control(goal, 0.5, 1000);
    double before = 1.0, largest = 0.0;
    bool has_met = false;
    for (int n = 0; n < 100000 && control.stage() == Stage::grows; ++n) {
      const PackingState state = packing.at(control.solid(), control.friction_factor());
      if (has_met) largest = std::max(largest, state.mean_stress);
      // When grains first meet, no contact had told how stiff they are.
      has_met = has_met || control.friction_factor() < 1.0;
      control.decide(state);
      EXPECT_LE(control.friction_factor(), before);
      before = control.friction_factor();
    }
    EXPECT_EQ(control.stage(), Stage::ended);
    EXPECT_LT(largest, goal.stress + 5e7 * 0.875 / 1000 / 0.95) << "contacts say " << contacts_say;
  }
}

// Stages so large that the jam is run over by 100 times the target.
TEST(GrowthControl, GoesBackWhereTheJamWasRunOver)
{
  const Packing stiff{1.0, 0.10, 1e9};
  GrowthControl control(goal, 0.5, 20);
  double largest = 0.0;
  for (int n = 0; n < 1000 && control.friction_factor() == 1.0; ++n) {
    const PackingState state = stiff.at(control.solid(), 1.0);
    largest = std::max(largest, state.mean_stress);
    control.decide(state);
  }
  EXPECT_GT(largest, 100.0 * goal.stress);
  EXPECT_NEAR(control.loosest(), 0.9, 0.9 * 2.0 * goal.stress / 1e9);
}

TEST(GrowthControl, WaitsWhileTheGrainsMove)
{
  GrowthControl control(goal, 0.5, 100);
  control.decide({4.8e3, 5e7, 0.5});
  EXPECT_EQ(control.friction_factor(), 1.0);
  EXPECT_EQ(control.solid(), 0.125);
  control.decide({4.8e3, 5e7, 0.005});
  EXPECT_DOUBLE_EQ(control.friction_factor(), 0.95);
  EXPECT_EQ(control.solid(), 0.125);
  control.decide({4.0e3, 5e7, 0.5});
  EXPECT_GT(control.solid(), 0.125);
}

TEST(GrowthControl, LowersFrictionAtFullSizeUntilTheStressIsMet)
{
  GrowthControl control(goal, 1.0, 100);
  control.decide({6e3, 5e7, 0.0});
  EXPECT_EQ(control.stage(), Stage::grows);
  EXPECT_DOUBLE_EQ(control.friction_factor(), 0.95);
  EXPECT_EQ(control.solid(), 1.0);
  control.decide({5e3, 5e7, 0.5});
  EXPECT_EQ(control.stage(), Stage::grows);
  control.decide({5e3, 5e7, 0.005});
  EXPECT_EQ(control.stage(), Stage::ended);
  EXPECT_DOUBLE_EQ(control.friction_factor(), 0.95);
}

TEST(GrowthControl, FindsAPorosityThatIsTooDense)
{
  const Packing loose{0.97, 0.10, 5e7};  // frictionless it jams before full size
  GrowthControl control(goal, 0.5, 1000);
  grow(control, loose);
  EXPECT_EQ(control.stage(), Stage::too_dense);
  EXPECT_EQ(control.friction_factor(), 0.0);
  EXPECT_NEAR(control.loosest(), 0.87, 2e-4);
  EXPECT_NEAR(control.densest(), 0.97, 2e-4);
}

TEST(GrowthControl, FindsAPorosityThatIsTooLoose)
{
  GrowthControl control(goal, 0.5, 100);
  grow(control, {1.2, 0.10, 5e7});  // with all friction it jams beyond full size
  EXPECT_EQ(control.stage(), Stage::too_loose);
  EXPECT_EQ(control.friction_factor(), 1.0);
}

TEST(GrowthControl, GivesUpOnGrainsThatDoNotComeToRest)
{
  GrowthControl control(goal, 0.5, 100);
  for (int n = 0; n < 10000 && control.stage() == Stage::grows; ++n)
    control.decide({5.0e3, 5e7, 0.5});
  EXPECT_EQ(control.stage(), Stage::restless);
}

// The densest packing is pressed with ten times the stress, and what that shortens it taken back.
TEST(GrowthControl, FindsBothLimits)
{
  const Packing packing{0.80, 0.10, 5e7};
  GrowthControl control(limits, 0.5, 1000);
  grow(control, packing);
  EXPECT_EQ(control.stage(), Stage::ended);
  EXPECT_NEAR(control.loosest(), 0.70 * (1.0 + 1e-4), 7e-5);  // bears 0.9 to 2 times the stress
  EXPECT_NEAR(control.densest(), 0.80 * (1.0 + 1e-4), 2e-5);
}

TEST(GrowthControl, GoesOnFromItsState)
{
  GrowthControl whole(goal, 0.5, 100);
  grow(whole, in_reach, 150);
  for (int n = 0; n < 3; ++n) whole.decide({1e3, 5e7, 0.5});  // grains give way, steps get larger
  ASSERT_EQ(whole.stage(), Stage::grows);
  ASSERT_LT(whole.friction_factor(), 1.0);
  GrowthControl part(goal, 0.5, 100);
  part.restore(whole.state());
  whole.decide({1e3, 5e7, 0.5});
  part.decide({1e3, 5e7, 0.5});
  EXPECT_EQ(part.solid(), whole.solid());
  grow(whole, in_reach);
  grow(part, in_reach);
  EXPECT_EQ(part.state(), whole.state());
}
