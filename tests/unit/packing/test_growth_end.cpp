// SPDX-License-Identifier: GPL-2.0-only
#include "packing/growth_end.h"

#include <gtest/gtest.h>

using namespace encased_column;
using Stage = GrowthControl::Stage;

namespace {

GrowthEnd end_at(Stage stage)
{
  GrowthEnd end;
  end.stage = stage;
  end.found = {4200.0, 5e7, 0.008};
  end.friction_factor = 0.3;
  end.porosity = 0.41;
  end.at_full_size = 0.38;
  end.loosest = 0.49;
  end.densest = 0.41;
  return end;
}

}  // namespace

TEST(GrowthEnd, NamesLoosestAndDensestWhereThePorosityIsTooDense)
{
  EXPECT_FALSE(end_at(Stage::too_dense).is_good());
  EXPECT_EQ(
      end_at(Stage::too_dense).in_words(),
      "the porosity must be in reach of the gradation at 5000 Pa, found 0.3800 where it packs "
      "from 0.4900 with all friction to 0.4100 without, write one in between in "
      "'create_packing' or a larger 'stress'");
}

TEST(GrowthEnd, SaysWhatWasMetAtFullSize)
{
  EXPECT_TRUE(end_at(Stage::ended).is_good());
  EXPECT_EQ(end_at(Stage::ended).in_words(),
            "full size at porosity 0.4100, mean stress 4200 Pa, friction times 0.3, unbalanced "
            "force ratio 0.008");
}

TEST(GrowthEnd, SaysWhatIsTooLooseAndWhatDoesNotRest)
{
  EXPECT_FALSE(end_at(Stage::too_loose).is_good());
  EXPECT_FALSE(end_at(Stage::restless).is_good());
  EXPECT_NE(end_at(Stage::too_loose).in_words().find("write a smaller one"), std::string::npos);
  EXPECT_NE(end_at(Stage::restless).in_words().find("found 0.008 after long at porosity 0.4100"),
            std::string::npos);
}

TEST(GrowthEnd, OfTheSearchForLimitsIsGoodWithBothOnly)
{
  GrowthEnd end = end_at(Stage::ended);
  end.goal.until = GrowthGoal::Until::limits;
  EXPECT_TRUE(end.is_good());
  EXPECT_EQ(end.in_words(),
            "packing limits at 5000 Pa: porosity 0.4900 with all friction, 0.4100 without");
  end.densest = 0.0;
  EXPECT_FALSE(end.is_good());
  EXPECT_NE(end.in_words().find("found the porosity 0.3800 reached"), std::string::npos);
}
