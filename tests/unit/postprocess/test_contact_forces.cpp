// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/inside_specimen.h"

#include "core/input_error.h"

#include <gtest/gtest.h>

using namespace encased_column;

// The page of fix output/contacts says that a level is any force above zero; its headings spell it
// with in_words(), as the rest of the project does.
TEST(LevelOfShare, IsTheForceThatTheHeadingSpells)
{
  EXPECT_EQ(level_of_share("share_above_20N [-]"), 20.0);
  for (const double level : {0.25, 2.5, 5.0, 40.0, 1e-5, 1e6})
    EXPECT_EQ(level_of_share("share_above_" + in_words(level) + "N [-]"), level) << level;
}

TEST(LevelOfShare, IsNothingForOtherHeadings)
{
  for (const char* heading : {"step [-]", "mean_force [N]", "contacts_above_20N [-]",
                              "share_above_20N [%]", "share_above_N [-]", "share_above_", ""})
    EXPECT_FALSE(level_of_share(heading)) << heading;
}

TEST(LevelOfShare, RefusesAWordThatIsNoNumber)
{
  EXPECT_THROW(level_of_share("share_above_manyN [-]"), InputError);
}
