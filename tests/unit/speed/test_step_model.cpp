// SPDX-License-Identifier: GPL-2.0-only
#include "bench/step_model.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

/// Geometry of the study's specimen: 53 051 grains between platens 0.2 m apart in a radius of 0.05
/// m.
StepParts specimen()
{
  StepParts parts;
  parts.grains_per_volume = 53051.0 / (pi * 0.05 * 0.05 * 0.2);
  parts.facet_area = 1e-5;
  parts.ghost_layer = 9e-3;
  parts.ghost_reach = 15.4e-3;
  return parts;
}

}  // namespace

TEST(StepModel, OfOneRankIsTheSumOfItsParts)
{
  StepParts parts = specimen();
  parts.contact = 40e-9;
  parts.contacts_per_grain = 1.5;
  parts.grain = 20e-9;
  parts.list = 1e-6;
  parts.list_every = 100.0;
  parts.facet = 70e-9;
  parts.sleeve_contact = 100e-9;
  parts.sleeve_list = 500e-9;
  parts.step = 5e-6;
  parts.node = 30e-9;
  parts.facet_list = 200e-9;
  parts.ghost = parts.latency = parts.small_sums = parts.add =
      1.0;  // no other rank: they cost nothing
  parts.node_bytes = 48.0;
  parts.crossing = 1e5;
  parts.fullest = 100.0;
  const double facets = 2.0 * pi * 0.05 * 0.2 / 1e-5;
  // A grain: 1.5 contacts of 40 ns, 20 ns, a hundredth of 1 us. A facet: 70, 100 and a hundredth of
  // 500 ns, half a node of 30 ns, a hundredth of 200 ns.
  EXPECT_NEAR(time_of_step(53051.0, 1, parts).all(),
              5e-6 + 53051.0 * (60e-9 + 20e-9 + 10e-9) + facets * (175e-9 + 15e-9 + 2e-9), 1e-12);
}

// What LIGGGHTS counted on the fullest of so many ranks (tests/bench/peers/README.md, 53 051
// grains).
TEST(StepModel, HasTheGhostsThatTheHostCounts)
{
  const StepParts parts = specimen();
  EXPECT_EQ(CutSpecimen(53051.0, 1, parts).ghosts(parts), 0.0);
  const std::pair<int, double> counted[] = {
      {2, 2424}, {4, 4698}, {8, 4242}, {16, 3599}, {32, 2756}};
  for (const auto& [ranks, ghosts] : counted)
    EXPECT_NEAR(CutSpecimen(53051.0, ranks, parts).ghosts(parts), ghosts, 0.06 * ghosts) << ranks;
}

TEST(StepModel, HasNoMoreGhostsThanOtherGrains)
{
  const StepParts parts = specimen();
  for (int ranks = 2; ranks <= 4096; ranks *= 2)
    EXPECT_LE(CutSpecimen(53051.0, ranks, parts).ghosts(parts), 53051.0 * (1.0 - 1.0 / ranks))
        << ranks;
}

// Two ranks of four slices exchange with one other, the middle ones with two; a quarter of a slice
// has two more beside it.
TEST(StepModel, CountsTheMessagesOfARank)
{
  const StepParts parts = specimen();
  EXPECT_EQ(CutSpecimen(53051.0, 1, parts).messages(parts), 0.0);
  EXPECT_EQ(CutSpecimen(53051.0, 2, parts).messages(parts), 1.0);
  EXPECT_EQ(CutSpecimen(53051.0, 4, parts).messages(parts), 2.0);
  EXPECT_EQ(CutSpecimen(53051.0, 8, parts).messages(parts), 3.0);
  EXPECT_EQ(CutSpecimen(53051.0, 16, parts).messages(parts), 4.0);
  // 64 ranks: slices of 12.5 mm, with a reach of 15.4 mm it asks the second next one too.
  EXPECT_EQ(CutSpecimen(53051.0, 64, parts).messages(parts), 6.0);
}

TEST(StepModel, SumsOverRanksInRoundsOfTwo)
{
  StepParts parts;
  parts.latency = 1e-6;
  parts.bandwidth = 1e9;
  parts.add = 1e-10;
  EXPECT_EQ(time_of_sum(8.0, 1, parts), 0.0);
  EXPECT_NEAR(time_of_sum(8.0, 1024, parts), 10.0 * (1e-6 + 8.0 * 1.1e-9), 1e-15);
  // A long one by parts: 2 x 3 rounds, then 7/8 of it twice over the network and once added.
  EXPECT_NEAR(time_of_sum(8e6, 8, parts), 6e-6 + 7e6 * (2e-9 + 1e-10), 1e-12);
}

// Each of 8 ranks learns 7 times what it sends, in 3 rounds.
TEST(StepModel, GathersInRoundsOfTwo)
{
  StepParts parts;
  parts.latency = 1e-6;
  parts.bandwidth = 1e9;
  EXPECT_EQ(time_of_gather(1e6, 1, parts), 0.0);
  EXPECT_NEAR(time_of_gather(1e6, 8, parts), 3e-6 + 7e-3, 1e-12);
}

// What one rank sent in a mean step, over 48 bytes (tests/bench/ranks messages quick, slices): a
// mean of ranks at the ends and in the middle.
TEST(StepModel, HasTheNodesThatRanksSend)
{
  StepParts parts = specimen();
  parts.facet_area = 1.084e-5;
  parts.node_layer = 5e-3;
  EXPECT_NEAR(CutSpecimen(53051.0, 2, parts).touched_nodes(parts), 74046.0 / 48.0, 30.0);
  // Two in the middle with two ends, two with one.
  const CutSpecimen four(53051.0, 4, parts);
  const double strip = four.nodes(parts) / 4.0;
  EXPECT_NEAR(strip + 0.75 * (four.touched_nodes(parts) - strip), 40822.0 / 48.0, 30.0);
}

// Without a sleeve, ghosts, messages and what no size changes, ranks divide all work.
TEST(StepModel, DividesTheWorkOfGrains)
{
  StepParts parts = specimen();
  parts.ghost_layer = 0.0;
  parts.contact = 40e-9;
  parts.contacts_per_grain = 1.5;
  parts.grain = 20e-9;
  parts.list = 1e-6;
  const double alone = time_of_step(53051.0, 1, parts).all();
  for (int ranks = 2; ranks <= 1024; ranks *= 2)
    EXPECT_NEAR(time_of_step(53051.0, ranks, parts).all(), alone / ranks, 1e-9 * alone) << ranks;
}
