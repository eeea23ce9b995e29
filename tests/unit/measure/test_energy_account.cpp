#include "measure/energy_account.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

EnergyAccount at_start()
{
  EnergyAccount e;
  e.work_platens = 1.0;
  e.work_gravity = -4.0;
  e.elastic = 2.0;
  e.kinetic = 0.5;
  e.work_side = 0.3;
  e.friction = 0.25;
  e.rolling = 0.125;
  e.dashpots = 0.7;
  e.damping = 0.9;
  return e;
}

/// The platens bring 10 J, the side takes 3 J, grains sink by 1 J: 8 J are stored or lost.
EnergyAccount later()
{
  EnergyAccount e = at_start();
  e.work_platens += 10.0;
  e.work_side -= 3.0;
  e.work_gravity += 1.0;
  e.elastic += 2.0;
  e.kinetic -= 0.25;
  e.friction += 3.0;
  e.rolling += 1.0;
  e.dashpots += 0.75;
  e.damping += 1.5;
  return e;
}

}  // namespace

TEST(EnergyError, IsZeroWhereWorkIsStoredOrLost)
{
  EXPECT_NEAR(energy_error(at_start(), later()), 0.0, 1e-15);
}

TEST(EnergyError, IsZeroAtTheStart)
{
  EXPECT_EQ(energy_error(at_start(), at_start()), 0.0);
  EXPECT_EQ(energy_error({}, {}), 0.0);
}

TEST(EnergyError, IsWhatIsMissingOverWhatWasAtHand)
{
  // each of them off by 0.3 J, of 2 J stored, 10 J and 3 J of work
  for (double EnergyAccount::*part :
       {&EnergyAccount::work_gravity, &EnergyAccount::elastic, &EnergyAccount::kinetic,
        &EnergyAccount::friction, &EnergyAccount::rolling, &EnergyAccount::dashpots,
        &EnergyAccount::damping}) {
    EnergyAccount now = later();
    now.*part += 0.3;
    EXPECT_NEAR(energy_error(at_start(), now), 0.3 / 15.0, 1e-15);
  }
}
