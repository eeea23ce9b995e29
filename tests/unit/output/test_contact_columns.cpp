// SPDX-License-Identifier: GPL-2.0-only
#include "output/contact_columns.h"

#include "core/keyword_table.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

const KeywordTable level_keyword{{"level", 1, "N", "", true}};

}  // namespace

TEST(ContactColumns, HaveTwoForEachLevelBehindTheOthers)
{
  const std::vector<std::string> headings = contact_headings({2.5, 20.0});
  ASSERT_EQ(headings.size(), 12u);
  EXPECT_EQ(headings[0], "step [-]");
  EXPECT_EQ(headings[6], "mean_force [N]");
  EXPECT_EQ(headings[8], "contacts_above_2.5N [-]");
  EXPECT_EQ(headings[11], "share_above_20N [-]");

  ContactForces forces({2.5, 20.0});
  forces.add(0, 2.0, false);
  forces.add(0, 4.0, true);
  forces.add(1, 30.0, false);
  forces.add(2, 12.0, false);
  EXPECT_EQ(contact_numbers({7.0, forces}),
            (std::vector<double>{7.0, 4.0, 2.0, 1.0, 1.0, 0.25, 12.0, 30.0, 3.0, 0.75, 1.0, 0.25}));
}

TEST(ContactColumns, TakeTheLevelsOfTheStudyWhereNoneIsGiven)
{
  const Options none = level_keyword.read(std::vector<std::string>());
  EXPECT_EQ(contact_levels(none), (std::vector<double>{5.0, 20.0, 40.0, 60.0}));
  EXPECT_EQ(none.understood(), "level 5 20 40 60");
  const Options two = level_keyword.read(std::vector<std::string>{"level", "3", "level", "1e2"});
  EXPECT_EQ(contact_levels(two), (std::vector<double>{3.0, 100.0}));
  EXPECT_EQ(two.understood(), "level 3, level 1e2");
}
