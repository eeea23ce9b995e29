// SPDX-License-Identifier: GPL-2.0-only
#include "output/grain_track.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(GrainTrack, GoesWithTheGrainThroughOrderAndRanks)
{
  GrainTrack track, other;
  track.grow(2);
  other.grow(1);
  const double start[] = {1.0, 2.0, 3.0}, spin[] = {0.0, 0.0, 0.0, 4.0, 5.0, 6.0};
  track.begin(1, start);
  track.turn(2, spin, 0.5);
  track.turn(2, spin, 0.25);
  track.copy(1, 0);
  track.grow(40);
  double buffer[GrainTrack::values_per_grain];
  EXPECT_EQ(track.pack(0, buffer), GrainTrack::values_per_grain);
  EXPECT_EQ(other.unpack(0, buffer), GrainTrack::values_per_grain);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(other.start(0)[k], start[k]);
    EXPECT_EQ(other.rotation(0)[k], 0.75 * spin[3 + k]);
  }
}

TEST(GrainTrack, BeginsAgainWithoutRotation)
{
  GrainTrack track;
  track.grow(1);
  const double spin[] = {1.0, 2.0, 3.0}, there[] = {7.0, 8.0, 9.0};
  track.turn(1, spin, 1.0);
  track.begin(0, there);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(track.rotation(0)[k], 0.0);
    EXPECT_EQ(track.start(0)[k], there[k]);
  }
}
