// SPDX-License-Identifier: GPL-2.0-only
#include "measure/seen_contact.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(CoordinationNumber, OfFourGrainsInARingIsTwo)
{
  EXPECT_DOUBLE_EQ(coordination_number({4.0, 8.0, 0.0, 0.0}), 2.0);
}

// Three in a row: the ends have one contact each, the middle two; no grain bears load by itself.
TEST(CoordinationNumber, OfARowOfThreeIsFourThirds)
{
  const ContactCount row{3.0, 4.0, 0.0, 2.0};
  EXPECT_DOUBLE_EQ(coordination_number(row), 4.0 / 3.0);
  EXPECT_DOUBLE_EQ(mechanical_coordination_number(row), 2.0);
}

// Thornton's definition, (2 Nc - N1) / (N - N0 - N1): a floating grain and one that hangs on the
// ring.
TEST(BearingCoordinationNumber, LeavesOutGrainsThatFloatOrHangOn)
{
  const ContactCount ring_and_two{6.0, 10.0, 1.0, 1.0};
  EXPECT_DOUBLE_EQ(mechanical_coordination_number(ring_and_two), 9.0 / 4.0);
}

TEST(CoordinationNumber, OfNothingIsZero)
{
  EXPECT_EQ(coordination_number({}), 0.0);
  EXPECT_EQ(mechanical_coordination_number({}), 0.0);
  EXPECT_EQ(mechanical_coordination_number({2.0, 2.0, 0.0, 2.0}), 0.0);
}
