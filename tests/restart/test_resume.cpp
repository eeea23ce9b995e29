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

  /// Kills a new run as soon as the shell command `reached` succeeds, goes on in `stage` on `ranks`
  /// ranks, and returns how that ended.
  static Outcome kill_and_go_on(const TemporaryFolder& folder, const std::string& reached,
                                int stage, int ranks = 1)
  {
    std::vector<std::string> arguments = arguments_in(folder);
    std::ofstream(folder.path() / "in.lmp") << plain_triaxial_deck();
    std::string command = "'" ENCASE_PROGRAM "' -in in.lmp";
    for (const std::string& argument : arguments) command += " " + argument;
    const Outcome killed = run_program({"bash", "-c",
                                        command + " & child=$!\nuntil " + reached +
                                            "; do\n  kill -0 $child || exit 1\n  sleep 0.005\n"
                                            "done\nkill -KILL $child\nwait $child"},
                                       folder.path());
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

const std::string in_growth = "grep -q '^ *2000 ' log.liggghts 2>/dev/null";
const std::string in_consolidation = "grep -q '^ *9000 ' log.liggghts 2>/dev/null";
const std::string in_shear = "[ -e restart_4 ] && [ $(wc -l <history.csv) -gt 3 ]";

}  // namespace

TEST_F(ResumedTriaxialTest, KilledWhileGrainsGrowEndsTheSame)
{
  const TemporaryFolder folder;
  const Outcome outcome = kill_and_go_on(folder, in_growth, 1);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  expect_the_same_results(folder);
}

TEST_F(ResumedTriaxialTest, KilledInConsolidationEndsTheSame)
{
  const TemporaryFolder folder;
  const Outcome outcome = kill_and_go_on(folder, in_consolidation, 3);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  expect_the_same_results(folder);
}

TEST_F(ResumedTriaxialTest, KilledInShearEndsTheSame)
{
  const TemporaryFolder folder;
  const Outcome outcome = kill_and_go_on(folder, in_shear, 4);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  expect_the_same_results(folder);
}

// Sums of other ranks have other round-off, so only the course is compared.
TEST_F(ResumedTriaxialTest, GoesOnWithAnotherNumberOfRanks)
{
  const TemporaryFolder folder;
  const Outcome outcome = kill_and_go_on(folder, in_shear, 4, 2);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const CsvTable resumed(folder.path() / "history.csv");
  EXPECT_EQ(resumed.column("step [-]"), history().column("step [-]"));
  EXPECT_NEAR(resumed.column("stress_bottom [Pa]").back(),
              history().column("stress_bottom [Pa]").back(), 1e3);
}
