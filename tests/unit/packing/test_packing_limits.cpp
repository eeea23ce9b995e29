// SPDX-License-Identifier: GPL-2.0-only
#include "packing/packing_limits.h"

#include "core/input_error.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace encased_column;

namespace {

const std::string limits_header =
    "gradation [-],distribution [-],finest [m],radius [m],height [m],friction [-],"
    "rolling_friction [-],modulus [Pa],stress [Pa],seed [-],loosest_porosity [-],"
    "densest_porosity [-]\n";
const std::string row_of_seed_1 = "g.csv,uniform,0.005,0.05,0.2,0.7,0.5,2e8,5e3,1,0.5,0.375\n";
const PackingCase wanted{"g.csv", "uniform", 5e-3, 0.05, 0.2, 0.7, 0.5};

PackingLimits limits_of(const std::string& text, const PackingCase& of = wanted)
{
  std::istringstream in(text);
  return read_packing_limits(in, "limits.csv", of);
}

std::string refusal_of(const std::string& text, const PackingCase& of = wanted)
{
  try {
    limits_of(text, of);
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "";
}

}  // namespace

// Porosities 0.5 and 0.375 are void ratios 1 and 0.6: half way lies 0.8, porosity 4/9.
TEST(PackingLimits, ArePassedInVoidRatio)
{
  const PackingLimits limits{0.5, 0.375};
  EXPECT_DOUBLE_EQ(limits.porosity_at(0.0), 0.5);
  EXPECT_DOUBLE_EQ(limits.porosity_at(1.0), 0.375);
  EXPECT_DOUBLE_EQ(limits.porosity_at(0.5), 4.0 / 9.0);
}

// Relative density by dry densities, (rho - rho_min) / (rho_max - rho_min) rho_max / rho, of a
// solid of density 1: rho = 1 - n.
TEST(PackingLimits, MeanTheRelativeDensityOfDryDensities)
{
  const PackingLimits limits{0.487, 0.391};
  for (const double d : {0.1, 0.4, 0.8}) {
    const double rho = 1.0 - limits.porosity_at(d), loose = 1.0 - 0.487, dense = 1.0 - 0.391;
    EXPECT_NEAR((rho - loose) / (dense - loose) * dense / rho, d, 1e-12);
  }
}

TEST(PackingLimits, AreTheMeanOfTheSeedsOfACase)
{
  const PackingLimits limits =
      limits_of("# of three rows two are of this case\n" + limits_header + row_of_seed_1 +
                "g.csv,uniform,0.005,0.05,0.2,0.7,0.5,2e8,5e3,2,0.52,0.385\n"
                "g.csv,uniform,0.002,0.05,0.2,0.7,0.5,2e8,5e3,1,0.4,0.3\n");
  EXPECT_DOUBLE_EQ(limits.loosest, 0.51);
  EXPECT_DOUBLE_EQ(limits.densest, 0.38);
}

// The deck of the limits writes the path it was given; a gradation is known by its file's name.
TEST(PackingLimits, KnowAGradationByItsFileWhereverItLies)
{
  const PackingLimits limits = limits_of(limits_header + "/home/me/my decks/" + row_of_seed_1);
  EXPECT_DOUBLE_EQ(limits.loosest, 0.5);
  EXPECT_DOUBLE_EQ(limits.densest, 0.375);
}

TEST(PackingLimits, AreRefusedOfAnotherCase)
{
  PackingCase others[] = {wanted, wanted, wanted, wanted, wanted, wanted, wanted};
  others[0].gradation = "h.csv";
  others[1].distribution = "log_uniform";
  others[2].finest = 1e-3;
  others[3].radius = 0.06;
  others[4].height = 0.1;
  others[5].friction = 0.8;
  others[6].rolling_friction = 0.0;
  for (const PackingCase& other : others)
    EXPECT_NE(refusal_of(limits_header + row_of_seed_1, other).find("found none in limits.csv for"),
              std::string::npos);
  EXPECT_EQ(refusal_of(limits_header + row_of_seed_1), "");
}

TEST(PackingLimits, AreRefusedWhereTheTableIsMalformed)
{
  EXPECT_NE(refusal_of("g.csv,uniform\n").find("limits.csv:1 must start with the line"),
            std::string::npos);
  EXPECT_NE(refusal_of(limits_header + "g.csv,uniform\n").find("must have 12 values, found 2"),
            std::string::npos);
  EXPECT_NE(refusal_of(limits_header + "g.csv,uniform,0.005,0.05,0.2,0.7,x,2e8,5e3,1,0.5,0.4\n")
                .find("found 'x'"),
            std::string::npos);
  EXPECT_NE(refusal_of(limits_header + "g.csv,uniform,0.005,0.05,0.2,0.7,0.5,2e8,5e3,1,0.4,0.5\n")
                .find("must have a loosest porosity above the densest"),
            std::string::npos);
}
