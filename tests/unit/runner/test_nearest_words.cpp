// SPDX-License-Identifier: GPL-2.0-only
// A wrong word is answered with those it may have been meant for.
#include "runner/nearest_words.h"

#include <gtest/gtest.h>

using namespace encased_column;

// Counted by hand.
TEST(NearestWords, CountLettersPutInLeftOutChangedAndSwapped)
{
  EXPECT_EQ(letters_apart("radius", "radius"), 0u);
  EXPECT_EQ(letters_apart("raduis", "radius"), 1u) << "swapped";
  EXPECT_EQ(letters_apart("radus", "radius"), 1u) << "left out";
  EXPECT_EQ(letters_apart("raddius", "radius"), 1u) << "put in";
  EXPECT_EQ(letters_apart("redius", "radius"), 1u) << "changed";
  EXPECT_EQ(letters_apart("kitten", "sitting"), 3u);
  EXPECT_EQ(letters_apart("", "four"), 4u);
  EXPECT_EQ(letters_apart("four", ""), 4u);
}

TEST(NearestWords, StandInOrderWithoutThoseThatAreFarAway)
{
  const std::vector<std::string> known{"porosity", "radius", "radial", "stress", "radius"};
  EXPECT_EQ(nearest_words("raduis", known), (std::vector<std::string>{"radius"}));
  EXPECT_EQ(nearest_words("radiul", known), (std::vector<std::string>{"radial", "radius"}));
  EXPECT_TRUE(nearest_words("xyz", known).empty());
}

TEST(NearestWords, AreThoseThatHoldTheWordToo)
{
  EXPECT_EQ(nearest_words("platen", {"servo/platen", "platens", "solve"}),
            (std::vector<std::string>{"platens", "servo/platen"}));
  EXPECT_TRUE(nearest_words("ab", {"a_long_word_with_ab"}).empty()) << "two letters say little";
}

TEST(NearestWords, MakeAClause)
{
  EXPECT_EQ(nearest_clause("raduis", {"radius"}), ", nearest is 'radius'");
  EXPECT_EQ(nearest_clause("form", {"from", "forms"}), ", nearest are 'forms' and 'from'");
  EXPECT_EQ(nearest_clause("form", {"from", "forms", "for"}),
            ", nearest are 'for', 'forms' and 'from'");
  EXPECT_EQ(nearest_clause("xyz", {"radius"}), "");
}
