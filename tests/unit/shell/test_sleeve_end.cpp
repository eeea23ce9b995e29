// SPDX-License-Identifier: GPL-2.0-only
#include "shell/sleeve_end.h"

#include "sleeve_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

/// What node 2 of a tube may do when its end is of this kind: velocity and spin after it was pushed
/// and turned along all axes, each 1 where it is free and 0 where it is held.
struct Freedom {
  Vec3 translation, rotation;
};

Freedom freedom_of(SleeveEnd end)
{
  ShellModel model = short_tube();
  add_supports(end, {2}, Vec3::UnitZ(), model.support());
  model.force(2) = model.moment(2) = Vec3::Ones();
  const double dt = 1e-6;
  model.advance(dt, 0.0);
  return {model.velocity()[2] * model.mass()[2] / dt,
          model.angular_velocity()[2] * model.inertia()[2] / dt};
}

void expect_freedom(SleeveEnd end, const Vec3& translation, const Vec3& rotation)
{
  const Freedom found = freedom_of(end);
  EXPECT_LT((found.translation - translation).norm(), 1e-12);
  EXPECT_LT((found.rotation - rotation).norm(), 1e-12);
}

}  // namespace

TEST(SleeveEnd, HeldAndPlatenLeaveRotationsFree)
{
  expect_freedom(SleeveEnd::held, Vec3::Zero(), Vec3::Ones());
  expect_freedom(SleeveEnd::platen, Vec3::Zero(), Vec3::Ones());
}

TEST(SleeveEnd, ClampedLeavesNothingFree)
{
  expect_freedom(SleeveEnd::clamped, Vec3::Zero(), Vec3::Zero());
}

TEST(SleeveEnd, RadialLeavesTheAxisAndTheRotationsFree)
{
  expect_freedom(SleeveEnd::radial, Vec3::UnitZ(), Vec3::Ones());
}

TEST(SleeveEnd, FreeLeavesAllFree)
{
  expect_freedom(SleeveEnd::free, Vec3::Ones(), Vec3::Ones());
}

TEST(SleeveEnd, EveryNameStandsForItsOwnKind)
{
  const auto& names = sleeve_end_names();
  EXPECT_EQ(names.size(), 5u);
  for (std::size_t n = 0; n < names.size(); ++n)
    EXPECT_EQ(static_cast<std::size_t>(sleeve_end_of(names[n])), n);
  EXPECT_EQ(sleeve_end_of("held"), SleeveEnd::held);
  EXPECT_EQ(sleeve_end_of("clamped"), SleeveEnd::clamped);
  EXPECT_EQ(sleeve_end_of("radial"), SleeveEnd::radial);
  EXPECT_EQ(sleeve_end_of("platen"), SleeveEnd::platen);
  EXPECT_EQ(sleeve_end_of("free"), SleeveEnd::free);
}

TEST(SleeveEnd, HoldsEveryNodeOfTheEndAndNoOther)
{
  std::vector<Support> supports;
  add_supports(SleeveEnd::held, {4, 9, 11}, Vec3::UnitZ(), supports);
  ASSERT_EQ(supports.size(), 3u);
  EXPECT_EQ(supports[0].node, 4);
  EXPECT_EQ(supports[2].node, 11);
}
