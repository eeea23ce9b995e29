// SPDX-License-Identifier: GPL-2.0-only
// What a deck offers is read from its files without running it, those that a variable chooses too.
#include "runner/deck.h"

#include "core/input_error.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace encased_column;
using encased_column::testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

class DeckFiles : public ::testing::Test {
 protected:
  DeckFiles()
  {
    fs::create_directory(common_);
    write("common/size_fine.lmp", "variable finest index 1  # [mm] grains\n");
    write("common/size_coarse.lmp", "variable finest index 5  # [mm] grains\n");
    write("common/values_b.lmp",
          "variable mu index 0.6  # [-] friction (measured)\ninclude ${common}/values_a.lmp\n");
    write("common/values_a.lmp",
          "variable mu index 0.8  # [-] friction (Table 1)\nvariable seam index 1  # [-] share\n");
    write("common/sleeve_a.lmp", "variable ends index held  # [-] ends\n");
    write("common/values_.lmp", "");
    write("trial.lmp",
          "variable size index coarse\nvariable values index a\n"
          "include ${common}/size_${size}.lmp\ninclude ${common}/values_${values}.lmp\n"
          "include ${common}/sleeve_${values}.lmp\ninclude shear_${stage}.lmp\n"
          "variable finest index 9\n");
  }

  void write(const std::string& file, const std::string& text) const
  {
    std::ofstream(folder_.path() / file) << text;
  }
  Deck read(const Settings& given) const
  {
    return read_deck("trial", folder_.path() / "trial.lmp", common_, given);
  }
  std::string refusal(const Settings& given) const
  {
    try {
      check_choices(read({}), given);
    } catch (const InputError& problem) {
      return problem.what();
    }
    return "";
  }

  TemporaryFolder folder_;
  fs::path common_ = folder_.path() / "common";
};

}  // namespace

TEST_F(DeckFiles, AreThoseThatTheGivenVariablesChoose)
{
  EXPECT_EQ(read({}).find("finest")->value, "5");
  EXPECT_EQ(read({{"size", "fine"}}).find("finest")->value, "1");
  EXPECT_EQ(read({{"values", "b"}}).find("finest")->value, "5");
}

// As the host has it: a variable of style index keeps its first definition.
TEST_F(DeckFiles, GiveAVariableTheValueThatStandsFirst)
{
  const Deck deck = read({{"values", "b"}});
  EXPECT_EQ(deck.find("mu")->value, "0.6");
  EXPECT_EQ(deck.find("mu")->meaning, "friction (measured)");
  EXPECT_EQ(deck.find("seam")->value, "1");
  EXPECT_EQ(deck.names(), (std::vector<std::string>{"size", "values", "finest", "mu", "seam"}));
}

TEST_F(DeckFiles, AreTheChoicesOfTheirVariable)
{
  EXPECT_EQ(read({}).choices("size"), (std::vector<std::string>{"coarse", "fine"}));
  EXPECT_EQ(read({}).choices("values"), (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(read({}).choices("finest").empty());
}

TEST_F(DeckFiles, ThatAreNotThereAreNamed)
{
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({{"values", "a"}, {"size", "fine"}, {"other", "x"}}), "");
  EXPECT_EQ(refusal({{"values", "../values_a"}}),
            "unknown values '../values_a', expected one of: a b");
  EXPECT_NE(refusal({{"values", "b"}})
                .find("found no 'sleeve_b.lmp', write it with the variables "
                      "of 'sleeve_a.lmp'"),
            std::string::npos);
}
