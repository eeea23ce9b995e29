// SPDX-License-Identifier: GPL-2.0-only
#include "core/periodic_box.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

int images(const PeriodicBox& box, const Vec3& x, const Vec3& from, const Vec3& to)
{
  int count = 0;
  box.for_images(x, from, to, [&](const Vec3& shift) {
    ++count;
    for (int a = 0; a < 3; ++a) {
      if (!box.periodic[a]) continue;
      EXPECT_GE(x(a) + shift(a), from(a) - 1e-12);
      EXPECT_LE(x(a) + shift(a), to(a) + 1e-12);
    }
  });
  return count;
}

}  // namespace

TEST(PeriodicBox, HasOneImageOfEverythingWhereNothingIsPeriodic)
{
  const PeriodicBox box{Vec3::Zero(), Vec3::Ones(), {false, false, false}};
  EXPECT_EQ(images(box, Vec3(5.0, 5.0, 5.0), Vec3::Zero(), Vec3::Ones()), 1);
}

// A block of 4 x 2 x 1 lengths holds so many images of any point, wherever the point stands.
TEST(PeriodicBox, HasAsManyImagesInABlockAsLengthsFit)
{
  const PeriodicBox box{Vec3(1.0, 2.0, 3.0), Vec3(0.5, 0.25, 2.0), {true, true, true}};
  const Vec3 size(4 * 0.5, 2 * 0.25, 2.0);
  for (const double at : {-0.93, 0.11, 0.77, 13.21}) {
    const Vec3 x = at * Vec3(1.0, 0.7, 1.3), from(-0.3, 7.0, 2.4);
    EXPECT_EQ(images(box, x, from, from + size), 8) << at;
  }
}

TEST(PeriodicBox, WrapsPointsIntoItAlongPeriodicDirectionsOnly)
{
  const PeriodicBox box{Vec3(-1.0, -1.0, -1.0), Vec3(2.0, 2.0, 2.0), {true, false, true}};
  const Vec3 x = box.wrapped(Vec3(1.5, 1.5, -7.25));
  EXPECT_DOUBLE_EQ(x.x(), -0.5);
  EXPECT_DOUBLE_EQ(x.y(), 1.5);
  EXPECT_DOUBLE_EQ(x.z(), 0.75);
}
