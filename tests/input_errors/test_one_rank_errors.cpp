// SPDX-License-Identifier: GPL-2.0-only
// An error that one rank alone finds ends the run with its sentence on the screen and in the log,
// although both are files and the rank has not opened the log.
#include "support/child_program.h"

#include <gtest/gtest.h>

using namespace encased_column::testing;

namespace {

/// A stack of grains in the upper half of the box, which is the second of two ranks'.
const std::string upper_half =
    opening_deck("grain_stack") + "displace_atoms all move 0 0 0.11 units box\n";

const std::string host_law = R"(
fix e all property/global youngsModulus peratomtype 5e6 5e6
fix nu all property/global poissonsRatio peratomtype 0.3 0.3
fix rest all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5
pair_style gran model hertz tangential history
pair_coeff * *
)";

struct Trial {
  const char* name;
  std::string lines;
  std::string sentence;
};

const Trial trials[] = {
    {"Ours", "neighbor 0.05 bin\nneigh_modify one 5 page 50\nfix move all motion\nrun 1\n",
     "a grain has more than 5 neighbours, write 'neigh_modify one' with a larger number"},
    {"TheHosts",
     "neighbor 0.05 bin\nneigh_modify one 5 page 50\nfix move all nve/sphere\n" + host_law +
         "run 1\n",
     "Neighbor list overflow, boost neigh_modify"},
};

void PrintTo(const Trial& trial, std::ostream* out)
{
  *out << trial.name;
}

class OneRankError : public ::testing::TestWithParam<Trial> {};

/// How often `text` says `sentence`.
int count(const std::string& text, const std::string& sentence)
{
  int found = 0;
  for (auto at = text.find(sentence); at != std::string::npos; at = text.find(sentence, at + 1))
    ++found;
  return found;
}

}  // namespace

TEST_P(OneRankError, IsOnTheScreenAndInTheLog)
{
  for (const int ranks : {1, 2}) {
    const TemporaryFolder folder;
    const Outcome outcome = run_deck(upper_half + GetParam().lines, ranks, folder.path());
    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_EQ(count(outcome.output, GetParam().sentence), 1) << outcome.output;
    const std::string log = read_text(folder.path() / "log.liggghts");
    EXPECT_EQ(count(log, GetParam().sentence), 1) << log;
    EXPECT_EQ(count(log, "Created 16 atoms"), 1) << "what stood before it is there too";
  }
}

TEST(OneRankErrors, AreInAScreenFileAndInTheLogTheDeckChose)
{
  const Trial& trial = trials[0];
  const TemporaryFolder folder;
  run_deck("log chosen.log\n" + upper_half + trial.lines, 2, folder.path(),
           {"-screen", "screen.txt"});
  const std::string log = read_text(folder.path() / "chosen.log");
  EXPECT_EQ(count(log, trial.sentence), 1) << log;
  EXPECT_EQ(count(read_text(folder.path() / "screen.txt"), trial.sentence), 1);
}

INSTANTIATE_TEST_SUITE_P(Trials, OneRankError, ::testing::ValuesIn(trials),
                         [](const auto& trial) { return trial.param.name; });
