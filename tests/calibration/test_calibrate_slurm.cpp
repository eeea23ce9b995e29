// SPDX-License-Identifier: GPL-2.0-only
// `encase calibrate --slurm`: runs of real decks as tasks of Slurm, stage by stage.
#include "support/one_node_slurm.h"
#include "support/run_command.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

/// One parameter of a test of a hundred grains: ten points and a round of two more.
void write_two_stages(const fs::path& folder)
{
  std::ofstream(folder / "a.yaml")
      << "name: small\nruns:\n  cases_file: small.csv\n  cases: [plain]\n  ranks: 1\n  jobs: 2\n"
         "  set: {strain_end: 0.01}\n  slurm_options: [time=10]\n"
         "parameters:\n  - {name: modulus, low: 5 MPa, high: 20 MPa, scale: log, unit: Pa}\n"
         "targets:\n  - {quantity: peak_q, case: plain, value: 40 kPa, tolerance: 0.01 %}\n"
         "design: {points: 10, repeated: 0, repeats: 1}\n"
         "search: {surrogates: [regression], folds: 3, rounds: 1, candidates: 2, samples: 400}\n";
}

Outcome calibrate_small(const fs::path& folder, const std::vector<std::string>& more)
{
  std::vector<std::string> words{ENCASE_COMMAND, "calibrate", "a.yaml"};
  words.insert(words.end(), more.begin(), more.end());
  return run_program(words, folder);
}

}  // namespace

TEST(CalibrateSlurm, FindsWhatItFindsWithoutSlurm)
{
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "slurm");
  const OneNodeSlurm slurm(folder.path() / "slurm");
  if (!slurm.missing().empty()) GTEST_SKIP() << "Slurm cannot start, " << slurm.missing();
  prepare_small_cases(folder.path());
  write_two_stages(folder.path());
  const auto wait_for_jobs = [&] {
    for (int n = 0; n < 1200 && !slurm.ask({"squeue", "-h"}).output.empty(); ++n)
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_EQ(slurm.ask({"squeue", "-h"}).output, "");
  };

  Outcome design = calibrate_small(folder.path(), {"--out", "out", "--slurm"});
  ASSERT_EQ(design.exit_code, 0) << design.output;
  EXPECT_TRUE(design.says("with 10 tasks")) << design.output;
  EXPECT_FALSE(design.says("for the report")) << design.output;
  EXPECT_TRUE(design.says("Submitted: when the jobs have ended, go on with --resume --slurm"))
      << design.output;
  wait_for_jobs();
  const Outcome round = calibrate_small(folder.path(), {"--out", "out", "--resume", "--slurm"});
  ASSERT_EQ(round.exit_code, 0) << round.output;
  EXPECT_TRUE(round.says("Design: 10 runs")) << round.output;
  EXPECT_TRUE(round.says("with 2 tasks")) << round.output;
  wait_for_jobs();
  const Outcome end = calibrate_small(folder.path(), {"--out", "out", "--resume", "--slurm"});
  ASSERT_EQ(end.exit_code, 0) << end.output;
  EXPECT_TRUE(end.says("Round 1: 12 runs")) << end.output;

  const Outcome alone = calibrate_small(folder.path(), {"--out", "alone"});
  ASSERT_EQ(alone.exit_code, 0) << alone.output;
  for (const char* file : {"parameters.txt", "parameters_small.lmp"})
    EXPECT_EQ(read_text(folder.path() / "out" / file), read_text(folder.path() / "alone" / file))
        << file;
}
