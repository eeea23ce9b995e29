// SPDX-License-Identifier: GPL-2.0-only
#include "host/restart_block.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

std::string sentence_of(const std::string& block)
{
  try {
    RestartBlock taken(block.c_str());
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "";
}

}  // namespace

TEST(RestartBlock, GivesBackNumbersAndTextBitByBit)
{
  const std::string block = restart_block({0.1, -0.0, 1e-310}, "frames 3");
  RestartBlock taken(block.c_str());
  EXPECT_EQ(taken.left(), 3u);
  EXPECT_EQ(taken.take(), 0.1);
  double rest[2];
  taken.take(rest, 2);
  EXPECT_TRUE(std::signbit(rest[0]));
  EXPECT_EQ(rest[1], 1e-310);
  EXPECT_STREQ(taken.text(), "frames 3");
}

// What the host leaves where the file ends too early: any bytes.
TEST(RestartBlock, RefusesEveryBlockThatIsCutOff)
{
  const std::string whole = restart_block({1.0, 2.0, 3.0, 4.0}, "text");
  for (std::size_t size = 0; size < whole.size(); ++size)
    for (const char rest : {'\x00', '\xff', 'x'}) {
      std::string cut = whole;
      std::fill(cut.begin() + static_cast<long>(size), cut.end(), rest);
      if (cut == whole) continue;  // the text ends in a 0
      EXPECT_NE(sentence_of(cut), "") << "cut at byte " << size;
    }
}

TEST(RestartBlock, RefusesALayoutOfAnotherKind)
{
  const std::string other(64, '\x01');
  EXPECT_EQ(sentence_of(other),
            "its part of the restart file must be whole and of this version, found one of another "
            "version of the program or of another fix, go on from another file or start the test "
            "again");
}

TEST(RestartBlock, RefusesToGiveMoreNumbersThanItHolds)
{
  const std::string block = restart_block({1.0});
  RestartBlock taken(block.c_str());
  taken.take();
  EXPECT_THROW(taken.take(), InputError);
}
