// SPDX-License-Identifier: GPL-2.0-only
#include "core/input_error.h"

#include <gtest/gtest.h>

using namespace encased_column;

TEST(ReadNumber, TakesWhatAUserWrites)
{
  EXPECT_EQ(read_number("radius", "0.05"), 0.05);
  EXPECT_EQ(read_number("radius", "+5e-2"), 0.05);
  EXPECT_EQ(read_number("radius", "-.5"), -0.5);
  EXPECT_EQ(read_number("radius", "3"), 3.0);
}

TEST(ReadNumber, RefusesHalfAWordAndWhatIsNotFinite)
{
  for (const char* word : {"0.1.7", "1e", "5mm", "nan", "inf", "-inf", "1e999", "", "+", " 1", "1 ",
                           "0x10", "1,5", "+-1"})
    EXPECT_THROW(read_number("radius", word), InputError) << "'" << word << "'";
}

TEST(ReadNumber, SaysWhichKeywordAndWhatItFound)
{
  try {
    read_number("radius", "5mm");
    FAIL() << "not refused";
  } catch (const InputError& problem) {
    EXPECT_STREQ(
        problem.what(),
        "'radius' takes a finite number, found '5mm', write for example '0.5' in its place");
  }
}

TEST(ReadInteger, TakesWholeNumbersOnly)
{
  EXPECT_EQ(read_integer("every", "200"), 200);
  EXPECT_EQ(read_integer("every", "-3"), -3);
  for (const char* word : {"200.0", "1e3", "2 00", "", "99999999999999999999", "many"})
    EXPECT_THROW(read_integer("every", word), InputError) << "'" << word << "'";
}

TEST(InWords, WritesNumbersAsAUserWould)
{
  EXPECT_EQ(in_words(1e-5), "1e-05");
  EXPECT_EQ(in_words(50000.0), "50000");
  EXPECT_EQ(in_words(-0.5), "-0.5");
}
