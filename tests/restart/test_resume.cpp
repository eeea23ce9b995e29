// SPDX-License-Identifier: GPL-2.0-only
// A test that was killed without warning goes on from the restart file of its stage, and ends as if
// nothing had happened.
#include "support/csv_table.h"
#include "support/small_triaxial.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

struct Stage {
  std::string line;  ///< of the deck that ends it
  int steps;         ///< the test is killed so many steps after its begin
};

/// A small test that nothing stopped, with a restart file every 700 steps: not where the host sorts
/// grains by itself.
class WholeTest {
 public:
  /// `more`: arguments besides.
  explicit WholeTest(const std::string& deck, std::vector<std::string> more = {})
      : deck_(deck),
        more_(std::move(more))
  {
    const Outcome outcome = run_deck(deck_, 1, folder_.path(), arguments_in(folder_));
    if (outcome.exit_code != 0) failure_ = outcome.output;
  }

  const std::string& failure() const { return failure_; }
  CsvTable history() const { return CsvTable(folder_.path() / "history.csv"); }

  /// Kills a new run in its stage `end`, number `stage`, goes on in that on `ranks` ranks, and
  /// returns how it ended. The run has itself killed: from outside it might be too late.
  Outcome kill_and_go_on(const TemporaryFolder& folder, const Stage& end, int stage,
                         int ranks = 1) const
  {
    std::vector<std::string> arguments = arguments_in(folder);
    std::string deck = deck_;
    const std::size_t place = deck.find("\n" + end.line);
    if (place == std::string::npos)
      throw std::runtime_error("no line '" + end.line + "' in the deck");
    deck.insert(place + 1, "run " + std::to_string(end.steps) + "\nshell sh die\n");
    std::ofstream(folder.path() / "in.lmp") << deck;
    std::ofstream(folder.path() / "die") << "kill -KILL $(cat pid)\n";
    std::string command = "echo $$ >pid; exec '" ENCASE_PROGRAM "' -in in.lmp";
    for (const std::string& argument : arguments) command += " " + argument;
    const Outcome killed = run_program({"bash", "-c", command}, folder.path());
    EXPECT_EQ(killed.exit_code, 137) << killed.output;
    EXPECT_TRUE(fs::exists(folder.path() / ("restart_" + std::to_string(stage))));
    EXPECT_FALSE(fs::exists(folder.path() / ("restart_" + std::to_string(stage + 1))));
    arguments.insert(arguments.end(), {"-var", "resume", std::to_string(stage)});
    return run_deck(deck_, ranks, folder.path(), arguments);
  }

  void expect_the_same_results(const TemporaryFolder& folder,
                               const std::vector<std::string>& files) const
  {
    for (const std::string& file : files)
      EXPECT_EQ(read_text(folder.path() / file), read_text(folder_.path() / file)) << file;
  }

 private:
  std::vector<std::string> arguments_in(const TemporaryFolder& folder) const
  {
    std::vector<std::string> arguments = prepare_small_triaxial(folder.path());
    arguments.insert(arguments.end(), {"-var", "restart_every", "700", "-var", "preload", "60e3"});
    arguments.insert(arguments.begin(), more_.begin(), more_.end());  // the first one counts
    return arguments;
  }

  std::string deck_;
  std::vector<std::string> more_;
  std::string failure_;
  TemporaryFolder folder_;
};

const std::vector<Stage> stages{
    {R"(if "${stress_packing} == 0" then "run 5000 upto")", 2000},
    {R"(if "${stress_packing} == 0" then "solve ratio average 1e-2)", 150},
    {"solve ratio average 1e-3", 1000},
    {"solve ratio ${criterion} ${limit}", 1000},
    {"run ${last_step} upto", 600}};

void expect_the_same_end_from_every_stage(const std::string& deck,
                                          const std::vector<std::string>& files)
{
  const WholeTest whole(deck);
  ASSERT_EQ(whole.failure(), "");
  for (int stage = 1; stage <= static_cast<int>(stages.size()); ++stage) {
    SCOPED_TRACE("killed in stage " + std::to_string(stage));
    const TemporaryFolder folder;
    const Outcome outcome = whole.kill_and_go_on(folder, stages[stage - 1], stage);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    whole.expect_the_same_results(folder, files);
  }
}

}  // namespace

// The first file is that of the state before the first step, while the fixes are being set up.
TEST(ResumedTriaxial, EndsTheSameFromTheFileOfTheFirstStep)
{
  const WholeTest whole(plain_triaxial_deck());
  ASSERT_EQ(whole.failure(), "");
  const TemporaryFolder folder;
  const Outcome outcome = whole.kill_and_go_on(folder, {stages[0].line, 400}, 1);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  whole.expect_the_same_results(folder, {"history.csv", "grains/grains.pvd"});
}

TEST(ResumedTriaxial, EndsTheSameFromEveryStage)
{
  expect_the_same_end_from_every_stage(plain_triaxial_deck(), {"history.csv", "grains/grains.pvd"});
}

// Such a growth ends when the stress is met, and the deck asks for that in pieces of its run.
TEST(ResumedTriaxial, EndsTheSameFromAGrowthUnderAStress)
{
  const WholeTest whole(
      plain_triaxial_deck(),
      {"-var", "porosity", "0.48", "-var", "stress_packing", "5e3", "-var", "mu_packing", "0.3"});
  ASSERT_EQ(whole.failure(), "");
  const TemporaryFolder folder;
  const Outcome outcome = whole.kill_and_go_on(folder, {stages[0].line, 2500}, 1);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  whole.expect_the_same_results(folder, {"history.csv"});
}

// The restart files of the first two stages hold a rigid sleeve, which the third one releases.
TEST(ResumedTriaxial, EncasedEndsTheSameFromEveryStage)
{
  expect_the_same_end_from_every_stage(encased_triaxial_deck(),
                                       {"history.csv", "sleeve.csv", "profile.csv"});
}

// Sums of other ranks have other round-off, so only the course is compared.
TEST(ResumedTriaxial, GoesOnWithAnotherNumberOfRanks)
{
  const WholeTest whole(plain_triaxial_deck());
  ASSERT_EQ(whole.failure(), "");
  const TemporaryFolder folder;
  const Outcome outcome = whole.kill_and_go_on(folder, stages[4], 5, 2);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const CsvTable resumed(folder.path() / "history.csv"), history = whole.history();
  EXPECT_EQ(resumed.column("step [-]"), history.column("step [-]"));
  EXPECT_NEAR(resumed.column("stress_bottom [Pa]").back(),
              history.column("stress_bottom [Pa]").back(), 1e3);
}
