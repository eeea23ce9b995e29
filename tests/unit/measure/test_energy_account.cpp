// SPDX-License-Identifier: GPL-2.0-only
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

double error_of(const EnergyAccount& start, const EnergyAccount& now)
{
  EnergyBalance balance;
  balance.start(start);
  return balance.error(now);
}

}  // namespace

TEST(EnergyBalance, IsClosedWhereWorkIsStoredOrLost)
{
  EXPECT_NEAR(error_of(at_start(), later()), 0.0, 1e-15);
}

TEST(EnergyBalance, IsClosedAtTheStart)
{
  EXPECT_EQ(error_of(at_start(), at_start()), 0.0);
  EXPECT_EQ(error_of({}, {}), 0.0);
}

// 2.5 J there at the start, 11 J that come in; of these 3 J go out again at the side.
TEST(EnergyBalance, IsOffByWhatIsMissingOverAllThatTookPart)
{
  for (double EnergyAccount::*part :
       {&EnergyAccount::elastic, &EnergyAccount::kinetic, &EnergyAccount::friction,
        &EnergyAccount::rolling, &EnergyAccount::dashpots, &EnergyAccount::damping}) {
    EnergyAccount now = later();
    now.*part -= 0.3;
    EXPECT_NEAR(error_of(at_start(), now), 0.3 / 13.5, 1e-15);
  }
}

// Each way in which energy can come in, be stored and be lost, alone, with 0.6 % missing.
TEST(EnergyBalance, ReadsWhatIsMissingWhereverTheEnergyCameFromAndWent)
{
  for (double EnergyAccount::*source :
       {&EnergyAccount::work_platens, &EnergyAccount::work_side, &EnergyAccount::work_gravity})
    for (double EnergyAccount::*sink :
         {&EnergyAccount::elastic, &EnergyAccount::kinetic, &EnergyAccount::friction,
          &EnergyAccount::rolling, &EnergyAccount::dashpots, &EnergyAccount::damping}) {
      EnergyAccount now;
      now.*source = 1e-3;
      now.*sink = 0.994e-3;
      EXPECT_NEAR(error_of({}, now), 0.006, 1e-14);
      now.*sink = 1e-3;
      EXPECT_EQ(error_of({}, now), 0.0);
    }
  for (double EnergyAccount::*stored : {&EnergyAccount::elastic, &EnergyAccount::kinetic}) {
    EnergyAccount start;
    start.*stored = 1e-3;
    EnergyAccount now;
    now.friction = 0.994e-3;
    EXPECT_NEAR(error_of(start, now), 0.006, 1e-14);
    now = {};
    now.work_side = -0.994e-3;
    EXPECT_NEAR(error_of(start, now), 0.006, 1e-14);
  }
}

// A grain of 1 kg in free fall from rest: m g h and m v^2 / 2 of its closed form.
TEST(EnergyBalance, OfAGrainInFreeFallIsRoundOff)
{
  for (double t = 1e-9; t < 10.0; t *= 10.0) {
    EnergyAccount now;
    now.work_gravity = 9.81 * (0.5 * 9.81 * t * t);
    now.kinetic = 0.5 * (9.81 * t) * (9.81 * t);
    EXPECT_LT(error_of({}, now), 1e-15) << "after " << t << " s";
  }
}

TEST(EnergyBalance, OfEnergyFromNothingIsOne)
{
  EnergyAccount now;
  now.kinetic = 1e-30;
  EXPECT_EQ(error_of({}, now), 1.0);
  now = {};
  now.damping = -1.0;  // put in by what should take out
  EXPECT_EQ(error_of({}, now), 1.0);
}

// An elastic specimen, loaded and unloaded: round-off of what it had stored is not all there is.
TEST(EnergyBalance, ForgetsNoEnergyThatWasGivenBack)
{
  EnergyBalance balance;
  balance.start({});
  EnergyAccount now;
  now.work_platens = now.elastic = 5.0;
  EXPECT_EQ(balance.error(now), 0.0);
  now.work_platens = 1e-15;
  now.elastic = 0.0;
  EXPECT_DOUBLE_EQ(balance.error(now), 2e-16);
  EnergyBalance resumed;
  resumed.resume({}, balance.most());
  EXPECT_EQ(resumed.error(now), balance.error(now));
  balance.start(now);
  EXPECT_EQ(balance.error({}), 1.0) << "a new start forgets it";
}
