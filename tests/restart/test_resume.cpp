// A test that was killed without warning goes on from the restart file of its stage, and ends as if
// nothing had happened.
#include "support/csv_table.h"
#include "support/small_triaxial.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

/// The small test with a restart file every 700 steps: not where the host sorts grains by itself.
class ResumedTriaxialTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite()
  {
    whole_ = new TemporaryFolder;
    const Outcome outcome =
        run_deck(plain_triaxial_deck(), 1, whole_->path(), arguments_in(*whole_));
    failure_ = outcome.exit_code == 0 ? "" : outcome.output;
  }
  static void TearDownTestSuite() { delete whole_; }
  void SetUp() override { ASSERT_EQ(failure_, ""); }

  static std::vector<std::string> arguments_in(const TemporaryFolder& folder)
  {
    std::vector<std::string> arguments = prepare_small_triaxial(folder.path());
    arguments.insert(arguments.end(), {"-var", "restart_every", "700"});
    return arguments;
  }

  /// Kills a new run `steps` steps before the deck's line `line`, goes on in `stage` on `ranks`
  /// ranks, and returns how that ended. The run has itself killed: from outside it might be too
  /// late.
  static Outcome kill_and_go_on(const TemporaryFolder& folder, const std::string& line, int steps,
                                int stage, int ranks = 1)
  {
    std::vector<std::string> arguments = arguments_in(folder);
    std::string deck = plain_triaxial_deck();
    const std::size_t place = deck.find("\n" + line);
    if (place == std::string::npos) throw std::runtime_error("no line '" + line + "' in the deck");
    deck.insert(place + 1, "run " + std::to_string(steps) + "\nshell sh die\n");
    std::ofstream(folder.path() / "in.lmp") << deck;
    std::ofstream(folder.path() / "die") << "kill -KILL $(cat pid)\n";
    std::string command = "echo $$ >pid; exec '" ENCASE_PROGRAM "' -in in.lmp";
    for (const std::string& argument : arguments) command += " " + argument;
    const Outcome killed = run_program({"bash", "-c", command}, folder.path());
    EXPECT_EQ(killed.exit_code, 137) << killed.output;
    EXPECT_TRUE(fs::exists(folder.path() / ("restart_" + std::to_string(stage))));
    EXPECT_FALSE(fs::exists(folder.path() / ("restart_" + std::to_string(stage + 1))));
    arguments.insert(arguments.end(), {"-var", "resume", std::to_string(stage)});
    return run_deck(plain_triaxial_deck(), ranks, folder.path(), arguments);
  }

  static CsvTable history() { return CsvTable(whole_->path() / "history.csv"); }

  static void expect_the_same_results(const TemporaryFolder& folder)
  {
    for (const char* file : {"history.csv", "grains/grains.pvd"})
      EXPECT_EQ(read_text(folder.path() / file), read_text(whole_->path() / file)) << file;
  }

 private:
  inline static TemporaryFolder* whole_ = nullptr;
  inline static std::string failure_;
};

const std::string growth = "run 5000 upto", consolidation = "solve ratio average ${limit}",
                  shear = "run ${last_step} upto";

}  // namespace

TEST_F(ResumedTriaxialTest, KilledWhileGrainsGrowEndsTheSame)
{
  const TemporaryFolder folder;
  const Outcome outcome = kill_and_go_on(folder, growth, 2000, 1);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  expect_the_same_results(folder);
}

TEST_F(ResumedTriaxialTest, KilledInConsolidationEndsTheSame)
{
  const TemporaryFolder folder;
  const Outcome outcome = kill_and_go_on(folder, consolidation, 1000, 3);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  expect_the_same_results(folder);
}

TEST_F(ResumedTriaxialTest, KilledInShearEndsTheSame)
{
  const TemporaryFolder folder;
  const Outcome outcome = kill_and_go_on(folder, shear, 600, 4);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  expect_the_same_results(folder);
}

// Sums of other ranks have other round-off, so only the course is compared.
TEST_F(ResumedTriaxialTest, GoesOnWithAnotherNumberOfRanks)
{
  const TemporaryFolder folder;
  const Outcome outcome = kill_and_go_on(folder, shear, 600, 4, 2);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const CsvTable resumed(folder.path() / "history.csv");
  EXPECT_EQ(resumed.column("step [-]"), history().column("step [-]"));
  EXPECT_NEAR(resumed.column("stress_bottom [Pa]").back(),
              history().column("stress_bottom [Pa]").back(), 1e3);
}
