// SPDX-License-Identifier: GPL-2.0-only
#include "runner/case_variables.h"

#include "core/input_error.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace encased_column;

namespace {

Deck deck_with(const std::vector<DeckVariable>& variables)
{
  Deck deck;
  deck.name = "trial";
  deck.variables = variables;
  return deck;
}

const Deck deck = deck_with({{"resolution", "quick", "", ""},
                             {"sigma3", "50e3", "[Pa]", ""},
                             {"modulus", "7e6", "[Pa]", ""},
                             {"modulus_side", "${modulus}", "[Pa]", ""}});

std::string sentence_of(const Settings& asked, const Settings& used)
{
  try {
    confirmed_variables("a", asked, used);
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "";
}

}  // namespace

// The host keeps the first value of a name: what comes last here must be the only one it is given.
TEST(CaseVariables, ReachTheHostOnceAndTheLastOneCounts)
{
  const Settings given = given_variables({{"sigma3", "100e3"}, {"resolution", "quick"}}, "paper",
                                         {{"sigma3", "5e3"}, {"sigma3", "6e3"}});
  EXPECT_EQ(given, (Settings{{"sigma3", "6e3"}, {"resolution", "paper"}}));
}

TEST(CaseVariables, AreRefusedWhereTheDeckHasNone)
{
  EXPECT_NO_THROW(check_names(deck, {{"sigma3", "1"}, {"resolution", "paper"}}));
  EXPECT_THROW(check_names(deck, {{"sigma3", "1"}, {"sigma_3", "1"}}), InputError);
}

TEST(CaseVariables, TakeTheirValueFromTheOneTheyNameUnlessTheyAreGiven)
{
  EXPECT_EQ(asked_variables(deck, {{"modulus", "9e6"}}).back().second, "9e6");
  EXPECT_EQ(asked_variables(deck, {{"modulus", "9e6"}, {"modulus_side", "3"}}).back().second, "3");
}

// The host is told where common/ lies, seen from the run folder.
TEST(CaseVariables, OfAFileInCommonHaveItsPathInTheRunFolder)
{
  const Deck strip = deck_with({{"strip", "${common}/strip.csv", "[-]", ""}});
  EXPECT_EQ(asked_variables(strip, {}).back().second, "input/common/strip.csv");
}

// A case runs elsewhere than the command was given.
TEST(CaseVariables, FindATableInCommonOrByItsPath)
{
  const encased_column::testing::TemporaryFolder folder;
  Deck deck = deck_with({{"gradation", "${common}/a.csv", "[-]", ""}});
  deck.common = folder.path();
  std::ofstream(folder.path() / "b.csv") << "x\n";
  const auto found = [&](const std::string& value) {
    return with_found_tables(deck, {{"gradation", value}}).front().second;
  };
  EXPECT_EQ(found("b.csv"), "input/common/b.csv");
  const std::string path = folder.path() / "b.csv";
  EXPECT_EQ(found(path), path);
  EXPECT_EQ(found(std::filesystem::relative(path).string()), path);
  EXPECT_THROW(found("c.csv"), InputError);
}

TEST(CaseVariables, AreTheSameWhereTheyAreTheSameNumber)
{
  EXPECT_TRUE(same_value("50e3", "50000"));
  EXPECT_TRUE(same_value("0.40", "0.4"));
  EXPECT_TRUE(same_value("held", "held"));
  EXPECT_FALSE(same_value("50e3", "5e3"));
  EXPECT_FALSE(same_value("held", "free"));
  EXPECT_FALSE(same_value("", "0"));
}

TEST(CaseVariables, TellTheFirstDifference)
{
  EXPECT_FALSE(first_difference({{"a", "1"}}, {{"a", "1.0"}}));
  EXPECT_EQ(first_difference({{"a", "1"}}, {{"a", "2"}}).there, "a=1");
  EXPECT_EQ(first_difference({{"a", "1"}}, {{"a", "2"}}).now, "a=2");
  EXPECT_EQ(first_difference({}, {{"a", "2"}}).there, "nothing");
  EXPECT_EQ(first_difference({{"a", "1"}}, {}).now, "nothing");
}

TEST(UsedVariables, MustBeThoseThatWereAskedFor)
{
  EXPECT_EQ(sentence_of({{"sigma3", "5e3"}}, {{"other", "1"}, {"sigma3", "5000"}}), "");
  const std::string wrong = sentence_of({{"sigma3", "5e3"}}, {{"sigma3", "50e3"}});
  EXPECT_NE(wrong.find("found 50e3 in the run and 5e3 asked for"), std::string::npos) << wrong;
  EXPECT_NE(sentence_of({{"sigma3", "5e3"}}, {}).find("does not know it"), std::string::npos);
}
