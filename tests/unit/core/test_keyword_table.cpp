// SPDX-License-Identifier: GPL-2.0-only
#include "core/keyword_table.h"

#include "core/input_error.h"

#include <gtest/gtest.h>

#include <functional>

using namespace encased_column;

namespace {

const KeywordTable table{
    {"center", 3, "m", "center of the sphere"}, {"radius", 1, "m", "its radius"},
    {"every", 1, "steps", "how often"},         {"mode", 1, "-", "slow or fast"},
    {"class", 2, "-", "a size class", true},    {"hold", 0, "-", "stands still"},
    {"ratio", 2, "-", "which, and its limit"},
};

void expect_refused(const std::function<void()>& act, const std::string& sentence)
{
  try {
    act();
    FAIL() << "not refused: " << sentence;
  } catch (const InputError& problem) {
    EXPECT_EQ(problem.what(), sentence);
  }
}

void expect_words_refused(const std::vector<std::string>& words, const std::string& sentence)
{
  expect_refused([&] { table.read(words); }, sentence);
}

}  // namespace

TEST(KeywordTable, ReadsKeywordsInAnyOrder)
{
  const Options options = table.read(
      std::vector<std::string>{"radius", "0.1", "hold", "center", "1", "-2", "3e-1", "every", "7"});
  EXPECT_EQ(options.vector("center"), Vec3(1.0, -2.0, 0.3));
  EXPECT_EQ(options.positive("radius"), 0.1);
  EXPECT_EQ(options.integer("every", 1), 7);
  EXPECT_TRUE(options.has("hold"));
  EXPECT_FALSE(options.has("mode"));
}

TEST(KeywordTable, KeepsEveryTurnOfAKeywordThatMayRepeat)
{
  const Options options =
      table.read(std::vector<std::string>{"class", "1", "2", "class", "2", "5"});
  EXPECT_EQ(options.all("class"), (std::vector<std::vector<std::string>>{{"1", "2"}, {"2", "5"}}));
}

TEST(KeywordTable, SkipsTheHostsOwnWords)
{
  const char* words[] = {"void", "all", "measure/sphere", "radius", "0.1"};
  EXPECT_EQ(table.read(5, const_cast<char**>(words)).number("radius"), 0.1);
}

TEST(KeywordTable, RefusesAKeywordItDoesNotKnow)
{
  expect_words_refused({"raduis", "0.1"},
                       "unknown keyword 'raduis', expected one of: center, radius, every, mode, "
                       "class, hold, ratio");
}

TEST(KeywordTable, RefusesAMissingValue)
{
  expect_words_refused({"center", "1", "2"},
                       "keyword 'center' takes 3 values, found 2, add what is missing: center of "
                       "the sphere");
  expect_words_refused({"radius"},
                       "keyword 'radius' takes 1 value, found 0, add what is missing: its radius");
}

TEST(KeywordTable, RefusesAKeywordGivenTwice)
{
  expect_words_refused({"radius", "1", "radius", "2"},
                       "keyword 'radius' stands twice, write it once");
}

TEST(Options, UseTheDefaultOnlyWhereNothingWasGiven)
{
  const Options options = table.read(std::vector<std::string>{"radius", "2", "mode", "fast"});
  EXPECT_EQ(options.number("radius", 5.0), 2.0);
  EXPECT_EQ(options.number("every", 5.0), 5.0);
  EXPECT_EQ(options.word("mode", "slow"), "fast");
  EXPECT_EQ(options.integer("every", 1, 200), 200);
}

TEST(Options, RefuseWhatIsMissing)
{
  const Options options = table.read(std::vector<std::string>{});
  expect_refused([&] { options.number("radius"); },
                 "keyword 'radius' is missing, add 'radius ...'");
}

TEST(Options, RefuseNumbersOutOfRange)
{
  const Options options =
      table.read(std::vector<std::string>{"radius", "0", "every", "-1", "mode", "quick"});
  expect_refused([&] { options.positive("radius"); },
                 "'radius' must be larger than zero, found 0, write for example 'radius 1'");
  expect_refused([&] { options.between("every", 0.0, 0.9); },
                 "'every' must be between 0 and 0.9, found -1, write for example 'every 0.5'");
  expect_refused([&] { options.not_negative("every", 0.0); },
                 "'every' must be zero or larger, found -1, write for example 'every 1'");
  expect_refused([&] { options.integer("every", 1); },
                 "'every' must be 1 or larger, found -1, write for example 'every 1'");
  expect_refused(
      [&] {
        options.choice("mode", {"slow", "fast"});
      },
      "'mode' must be one of: slow, fast; found 'quick', write for example 'mode slow'");
}

TEST(Options, NameAWholeNumberTooLargeInAllItsDigits)
{
  const Options options = table.read(std::vector<std::string>{"every", "2147483648"});
  expect_refused([&] { options.integer("every", 1); },
                 "'every' must be at most 2147483647, found 2147483648, write for example 'every "
                 "2147483647'");
}

TEST(Options, KeepTheOtherValuesOfAKeywordInWhatToWrite)
{
  const Options options = table.read(std::vector<std::string>{"ratio", "mean", "1e-5"});
  expect_refused(
      [&] {
        options.choice("ratio", {"average", "maximum"});
      },
      "'ratio' must be one of: average, maximum; found 'mean', write for example 'ratio average "
      "1e-5'");
}

// Whoever writes what a refusal says is not refused again.
TEST(Options, TakeWhatTheirRefusalsSayToWrite)
{
  const std::vector<std::function<void(const Options&)>> rules{
      [](const Options& o) { o.positive("radius"); },
      [](const Options& o) { o.not_negative("radius", 0.0); },
      [](const Options& o) { o.between("radius", 0.01, 1.9); },
      [](const Options& o) { o.between("radius", 97.0, 98.0); },
      [](const Options& o) { o.between("radius", -3.0, -2.9999999); },
      [](const Options& o) { o.between("radius", 7.0, 7.0); },
      [](const Options& o) { o.integer("radius", -12); },
      [](const Options& o) { o.integer("radius", 3); },
      [](const Options& o) {
        o.choice("radius", {"small", "large"});
      },
  };
  int refusals = 0;
  for (const char* word : {"0", "-0.3", "-1e300", "-5e-324", "2", "-13", "3000000000"})
    for (const auto& rule : rules) try {
        rule(table.read(std::vector<std::string>{"radius", word}));
      } catch (const InputError& problem) {
        const std::string sentence = problem.what(), lead = "write for example 'radius ";
        if (sentence.find("takes a whole number") != std::string::npos) continue;
        ASSERT_NE(sentence.find(lead), std::string::npos) << sentence;
        const std::string advice = sentence.substr(sentence.find(lead) + lead.size());
        ASSERT_EQ(advice.back(), '\'');
        const std::vector<std::string> better{"radius", advice.substr(0, advice.size() - 1)};
        EXPECT_NO_THROW(rule(table.read(better))) << sentence;
        ++refusals;
      }
  EXPECT_GT(refusals, 30);
}

TEST(Options, TakeTheLimitsOfARangeThemselves)
{
  const Options options = table.read(std::vector<std::string>{"radius", "0.8"});
  EXPECT_EQ(options.between("radius", 0.8, 1.0), 0.8);
  EXPECT_EQ(options.between("radius", 0.1, 0.8), 0.8);
  EXPECT_EQ(table.read(std::vector<std::string>{"every", "3"}).integer("every", 3), 3);
}

TEST(Options, SayWhatTheyUnderstoodWithDefaultsInTheOrderOfTheTable)
{
  const Options options = table.read(
      std::vector<std::string>{"hold", "class", "1", "2", "radius", "7e-1", "class", "3", "4"});
  EXPECT_EQ(options.understood(), "radius 7e-1, class 1 2, class 3 4, hold");
  EXPECT_EQ(options.integer("every", 1, 50), 50);
  EXPECT_EQ(options.choice("mode", {"slow", "fast"}, "slow"), "slow");
  EXPECT_EQ(options.positive("radius", 3.0), 0.7);
  options.assume("center", "0 0 0");
  options.assume("hold", "not, as it is given");
  EXPECT_EQ(options.understood(),
            "center 0 0 0, radius 7e-1, every 50, mode slow, class 1 2, class 3 4, hold");
}

TEST(Options, SayEveryKindOfDefault)
{
  const auto understood = [](const std::function<void(const Options&)>& ask) {
    const Options options = table.read(std::vector<std::string>());
    ask(options);
    return options.understood();
  };
  EXPECT_EQ(understood([](const Options& o) { o.number("radius", -2.5); }), "radius -2.5");
  EXPECT_EQ(understood([](const Options& o) { o.positive("radius", 1e-5); }), "radius 1e-05");
  EXPECT_EQ(understood([](const Options& o) { o.not_negative("radius", 0.0); }), "radius 0");
  EXPECT_EQ(understood([](const Options& o) { o.between("radius", 0.0, 1.0, 0.7); }), "radius 0.7");
  EXPECT_EQ(understood([](const Options& o) { o.integer("every", 1, 200); }), "every 200");
  EXPECT_EQ(understood([](const Options& o) { o.word("mode", "slow"); }), "mode slow");
  EXPECT_EQ(understood([](const Options& o) { o.choice("mode", {"a"}, "a"); }), "mode a");
  EXPECT_EQ(understood([](const Options& o) { o.assume("hold", ""); }), "hold");
  EXPECT_EQ(understood([](const Options&) {}), "");
}
