// SPDX-License-Identifier: GPL-2.0-only
// A user stops, kills and resumes `encase run` at any moment and loses nothing. Each case is
// stopped in one stage after the other, by another signal each time, and must end as one never
// stopped.
#include "support/csv_table.h"
#include "support/run_command.h"

#include <gtest/gtest.h>

#include <csignal>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

class Stop : public ::testing::Test {
 protected:
  static void SetUpTestSuite()
  {
    folder_ = new TemporaryFolder;
    prepare_small_cases(folder_->path());
    RunningCommand whole(folder_->path(), "whole",
                         {"--case", "plain", "--case", "encased", "--ranks", "1"});
    failure_ = whole.end().exit_code == 0 ? "" : read_text(folder_->path() / "whole.screen");
  }
  static void TearDownTestSuite() { delete folder_; }
  void SetUp() override { ASSERT_EQ(failure_, ""); }

  static fs::path folder_of(const std::string& out, const std::string& id)
  {
    return folder_->path() / out / id;
  }
  static bool has(const std::string& out, const std::string& id, const std::string& file)
  {
    return fs::exists(folder_of(out, id) / file);
  }
  static std::vector<std::string> options(const std::string& id, int ranks)
  {
    return {"--case", id, "--ranks", std::to_string(ranks)};
  }
  static std::vector<std::string> and_resume(std::vector<std::string> words)
  {
    words.push_back("--resume");
    return words;
  }
  static std::string last_line(const Outcome& outcome)
  {
    const std::vector<std::string> lines = outcome.lines();
    return lines.empty() ? "" : lines.back();
  }
  static bool log_has(const std::string& out, const std::string& id, const std::string& words)
  {
    const fs::path log = folder_of(out, id) / "log.liggghts";
    return fs::exists(log) && read_text(log).find(words) != std::string::npos;
  }
  static void expect_the_same_results(const std::string& out, const std::string& id)
  {
    for (const char* file : {"history.csv", "grains/grains.pvd"})
      EXPECT_EQ(read_text(folder_of(out, id) / file), read_text(folder_of("whole", id) / file))
          << file;
  }
  // Sums over ranks have another round-off each time, so only the course is compared.
  static void expect_the_same_course_on_two_ranks(const std::string& out)
  {
    if (!has("whole_2", "plain", "finished")) {
      ASSERT_EQ(RunningCommand(folder_->path(), "whole_2", options("plain", 2)).end().exit_code, 0);
    }
    const CsvTable resumed(folder_of(out, "plain") / "history.csv");
    const CsvTable whole(folder_of("whole_2", "plain") / "history.csv");
    EXPECT_EQ(resumed.column("axial_strain [-]").size(), whole.column("axial_strain [-]").size());
    EXPECT_NEAR(resumed.column("stress_bottom [Pa]").back(),
                whole.column("stress_bottom [Pa]").back(), 1e3);
  }
  /// Kills the command alone; the case hears of it and stops too.
  static void kill_and_resume(const std::string& out, int ranks)
  {
    {
      RunningCommand command(folder_->path(), out, options("plain", ranks));
      ASSERT_TRUE(command.wait_until([&] { return has(out, "plain", "restart_4"); }));
      command.send(SIGKILL);
      EXPECT_EQ(command.end().exit_code, 137);
    }
    const Outcome outcome =
        RunningCommand(folder_->path(), out, and_resume(options("plain", ranks))).end();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_TRUE(outcome.says("Case plain goes on in stage ")) << outcome.output;
  }
  /// Sends `signal` once the log of this start has come to `words`; the exit code and what is
  /// resumable must be told.
  static void stop_at(const std::string& out, const std::string& id, int ranks, int signal,
                      const std::string& words)
  {
    fs::remove(folder_of(out, id) / "log.liggghts");  // of the start before
    RunningCommand command(folder_->path(), out, and_resume(options(id, ranks)));
    ASSERT_TRUE(command.wait_until([&] { return log_has(out, id, words); }))
        << words << read_text(folder_->path() / (out + ".screen"));
    command.send(signal);
    const Outcome outcome = command.end();
    EXPECT_EQ(outcome.exit_code, 128 + signal) << outcome.output;
    EXPECT_EQ(last_line(outcome).rfind("Stopped; --resume ", 0), 0u) << outcome.output;
    EXPECT_TRUE(log_has(out, id, "Stopped by a signal at step ")) << outcome.output;
    EXPECT_FALSE(has(out, id, "finished"));
  }
  static void stop_in_every_stage(const std::string& id, int ranks)
  {
    const std::string out = id + "_" + std::to_string(ranks);
    stop_at(out, id, ranks, SIGINT, "create_packing");
    stop_at(out, id, ranks, SIGTERM, "\nfix grow");
    stop_at(out, id, ranks, SIGHUP, "\nsolve ratio average 1e-2");
    stop_at(out, id, ranks, SIGINT, "\nfix gravity");
    stop_at(out, id, ranks, SIGTERM, "\nfix chains");
    const Outcome outcome =
        RunningCommand(folder_->path(), out, and_resume(options(id, ranks))).end();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_TRUE(has(out, id, "finished"));
  }

  inline static TemporaryFolder* folder_ = nullptr;
  inline static std::string failure_;
};

}  // namespace

TEST_F(Stop, InEveryStageOfAPlainTestLosesNothing)
{
  stop_in_every_stage("plain", 1);
  expect_the_same_results("plain_1", "plain");
}

TEST_F(Stop, InEveryStageOfAnEncasedTestLosesNothing)
{
  stop_in_every_stage("encased", 1);
}

TEST_F(Stop, StopsTwoRanksAtTheSameStep)
{
  stop_in_every_stage("plain", 2);
  expect_the_same_course_on_two_ranks("plain_2");
}

TEST_F(Stop, OfTheFirstMomentBeginsAgain)
{
  RunningCommand command(folder_->path(), "early", options("plain", 1));
  ASSERT_TRUE(command.wait_until([&] { return has("early", "plain", "command.txt"); }));
  command.send(SIGTERM);
  const Outcome outcome = command.end();
  EXPECT_EQ(outcome.exit_code, 143) << outcome.output;
  EXPECT_EQ(last_line(outcome).rfind("Stopped; --resume ", 0), 0u) << outcome.output;
}

TEST_F(Stop, SecondSignalKills)
{
  RunningCommand command(folder_->path(), "twice", options("plain", 2));
  ASSERT_TRUE(command.wait_until([&] { return log_has("twice", "plain", "create_packing"); }));
  command.send(SIGINT);
  command.send(SIGTERM);
  const Outcome outcome = command.end();
  EXPECT_EQ(outcome.exit_code, 130) << outcome.output;
  EXPECT_EQ(last_line(outcome).rfind("Stopped; --resume ", 0), 0u) << outcome.output;
}

TEST_F(Stop, KilledItselfLeavesNoCaseRunning)
{
  kill_and_resume("killed", 1);
  expect_the_same_results("killed", "plain");
}

TEST_F(Stop, KilledItselfLeavesNoneOfTwoRanksRunning)
{
  kill_and_resume("killed_2", 2);
  expect_the_same_course_on_two_ranks("killed_2");
}

TEST_F(Stop, CaseThatStillRunsIsNotStartedTwice)
{
  const fs::path folder = folder_of("busy", "plain");
  fs::create_directories(folder);
  // In place of a case that has outlived its command: it holds the lock and does nothing.
  const Outcome outcome = run_program(
      {"flock", folder / ".lock", ENCASE_COMMAND, "run", "--cases", folder_->path() / "small.csv",
       "--out", folder_->path() / "busy", "--case", "plain"},
      folder_->path());
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(outcome.says("case 'plain' must not run twice in '")) << outcome.output;
}

TEST_F(Stop, GoesOnFromAnOlderStageWhereARestartFileIsCutOff)
{
  const fs::path from = folder_of("whole", "plain"), to = folder_of("torn", "plain");
  fs::create_directories(to.parent_path());
  fs::copy(from, to, fs::copy_options::recursive);
  fs::remove(to / "finished");
  fs::resize_file(to / "restart_5", fs::file_size(to / "restart_5") / 2);
  const Outcome outcome =
      RunningCommand(folder_->path(), "torn", and_resume(options("plain", 1))).end();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_TRUE(outcome.says("Case plain goes on in stage 4, restart_5 is cut off"))
      << outcome.output;
  expect_the_same_results("torn", "plain");
}
