#include "measure/specimen_state.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(Shortening, IsPositiveInCompression)
{
  EXPECT_DOUBLE_EQ(shortening(0.2, 0.16), 0.2);
  EXPECT_DOUBLE_EQ(shortening(0.05, 0.055), -0.1);
}

TEST(MeanAndDeviatoricStress, SplitAnAxisymmetricStress)
{
  EXPECT_DOUBLE_EQ(mean_stress(250e3, 100e3), 150e3);
  EXPECT_DOUBLE_EQ(deviatoric_stress(250e3, 100e3), 150e3);
  // sigma_1 = p + 2 q / 3 whatever the two are
  EXPECT_DOUBLE_EQ(mean_stress(310e3, 70e3) + 2.0 / 3.0 * deviatoric_stress(310e3, 70e3), 310e3);
}

TEST(Porosity, OfASphereInItsCubeIsThatOfTheSimpleCubicLattice)
{
  const double pi = 3.14159265358979323846;
  EXPECT_NEAR(porosity(pi / 6.0, 1.0), 0.476401, 5e-7);
}
