// SPDX-License-Identifier: GPL-2.0-only
// The strain that `fix output/grains` finds where grains fly apart in a homogeneous shear.
#include "verification/output/vtp_file.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column::testing;

namespace {

/// The stack with grains of half the size, which touch nothing, moves 5 mm along `axis` per 80 mm
/// of height.
std::vector<double> strain_of_flight(const std::string& axis, const std::string& words, int ranks)
{
  const TemporaryFolder folder;
  const Outcome outcome =
      run_deck(opening_deck("grain_stack") +
                   "set group all diameter 0.01 density 2500\nfix move all nve/sphere\n"
                   "velocity all ramp v" +
                   axis +
                   " 0 0.5 z 0 0.08 units box\n"
                   "fix pictures all output/grains every 1000 folder grains " +
                   words + "\nrun 1000\n",
               ranks, folder.path());
  if (outcome.exit_code != 0) throw std::runtime_error(outcome.output);
  return VtpFile(folder.path() / "grains/grains_000001000.vtp").of_points("deviatoric_strain [-]");
}

}  // namespace

// Principal stretches of a shear by gamma are m +- gamma / 2 and 1, m = sqrt(1 + gamma^2 / 4).
TEST(StrainInGrainsFile, IsThatOfAHomogeneousShearOnOneAndTwoRanks)
{
  const double gamma = 0.5 / 0.08 * 1e-2, m = std::sqrt(1.0 + 0.25 * gamma * gamma);
  const double mean = (2.0 * m + 1.0) / 3.0;
  const double squares = std::pow(m + 0.5 * gamma - mean, 2) + std::pow(m - 0.5 * gamma - mean, 2) +
                         std::pow(1.0 - mean, 2);
  const std::vector<double> one = strain_of_flight("x", "strain_range 0.045", 1);
  ASSERT_EQ(one.size(), 16u);
  for (const double strain : one) EXPECT_NEAR(strain, std::sqrt(2.0 / 3.0 * squares), 1e-6);
  const std::vector<double> two = strain_of_flight("x", "strain_range 0.045", 2);
  ASSERT_EQ(two.size(), 16u);
  for (std::size_t n = 0; n < one.size(); ++n) EXPECT_FLOAT_EQ(two[n], one[n]);
}

// Counted from where displacements start: from where the grains are it would be 2/3 of 0.0588.
TEST(StrainInGrainsFile, IsThatOfAHomogeneousStretch)
{
  for (const double strain : strain_of_flight("z", "strain_range 0.045", 1))
    EXPECT_NEAR(strain, 2.0 / 3.0 * 0.0625, 1e-6);
}

// Without a word about it the range is 1.5 diameters, 15 mm; the next grain is 20 mm away.
TEST(StrainInGrainsFile, IsMinusOneWhereNoNeighbourIsNear)
{
  for (const double strain : strain_of_flight("x", "", 1)) EXPECT_EQ(strain, -1.0);
}

TEST(StrainInGrainsFile, IsLeftOutWhenItsRangeIsZero)
{
  EXPECT_THROW(strain_of_flight("x", "strain_range 0", 1), std::runtime_error);
}
