// SPDX-License-Identifier: GPL-2.0-only
// A series on a cluster: Slurm runs its cases as tasks, through a kill and a stop before the time
// is over, and the table is that of a run without Slurm.
#include "runner/slurm_job.h"
#include "support/one_node_slurm.h"
#include "support/run_command.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <thread>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

bool comes_true(const std::function<bool()>& happened, int seconds)
{
  for (int n = 0; n < 100 * seconds; ++n) {
    if (happened()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

void write_program(const fs::path& file, const std::string& text)
{
  std::ofstream(file) << "#!/bin/bash\n" << text;
  chmod(file.c_str(), 0700);
}

std::string text_of(const fs::path& file)
{
  return fs::exists(file) ? read_text(file) : "";
}

/// PATH with `folder` before all others, as long as this object lives.
class PathWith {
 public:
  explicit PathWith(const fs::path& folder) : before_(getenv("PATH"))
  {
    setenv("PATH", (folder.string() + ":" + before_).c_str(), 1);
  }
  ~PathWith() { setenv("PATH", before_.c_str(), 1); }
  PathWith(const PathWith&) = delete;
  PathWith& operator=(const PathWith&) = delete;

 private:
  std::string before_;
};

const std::vector<std::string> on_cluster{"--series", "all",   "--slurm",         "--slurm-option",
                                          "time=10",  "--set", "strain_end=0.005"};

}  // namespace

TEST(Slurm, SeriesThatIsKilledAndStoppedHasTheTableOfOneThatWasNot)
{
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "slurm");
  const OneNodeSlurm slurm(folder.path() / "slurm");
  if (!slurm.missing().empty()) GTEST_SKIP() << "Slurm cannot start, " << slurm.missing();
  prepare_small_cases(folder.path());
  const Outcome submitted = RunningCommand(folder.path(), "out", on_cluster).end();
  ASSERT_EQ(submitted.exit_code, 0) << submitted.output;
  ASSERT_TRUE(submitted.says("with 2 tasks (encased plain) and job ")) << submitted.output;
  const std::string job = std::to_string(static_cast<int>(submitted.value("Submitted job")));

  const fs::path out = folder.path() / "out";
  ASSERT_TRUE(comes_true([&] { return fs::exists(out / "plain/restart_1"); }, 60));
  slurm.ask({"scancel", "--signal=USR1", "--batch", job + "_1"});
  ASSERT_TRUE(comes_true([&] { return fs::exists(out / "encased/restart_2"); }, 60));
  // All its processes at once, as where a node fails.
  slurm.ask({"bash", "-c",
             "kill -KILL $(scontrol listpids $(squeue -h -j " + job +
                 "_0 -o %A) | awk 'NR > 1 && $1 > 0 { print $1 }')"});
  ASSERT_TRUE(comes_true(
      [&] {
        return slurm.ask({"scontrol", "requeue", job + "_0"}).exit_code == 0;
      },
      20));

  EXPECT_TRUE(comes_true([&] { return fs::exists(out / "cases.txt"); }, 120))
      << slurm.ask({"squeue"}).output;
  EXPECT_TRUE(text_of(out / "slurm/case_1.txt").find("Stopped; --resume goes on with plain") !=
              std::string::npos)
      << text_of(out / "slurm/case_1.txt");
  for (const char* task : {"case_0.txt", "case_1.txt"})
    EXPECT_NE(text_of(out / "slurm" / task).find(" goes on in stage "), std::string::npos)
        << text_of(out / "slurm" / task);
  const Outcome whole =
      RunningCommand(folder.path(), "whole",
                     {"--series", "all", "--ranks", "1", "--set", "strain_end=0.005"})
          .end();
  ASSERT_EQ(whole.exit_code, 0) << whole.output;
  for (const char* file : {"cases.txt", "table.txt", "checks.txt"})
    EXPECT_EQ(text_of(out / file), text_of(folder.path() / "whole" / file)) << file;
}

TEST(Slurm, TaskAskedToStopPutsItselfInTheQueueAgain)
{
  const TemporaryFolder folder;
  write_program(folder.path() / "scontrol", "echo \"$@\" >asked.txt\n");
  write_program(folder.path() / "stub",
                "trap 'exit 138' USR1\necho \"$@\" >\"$2/words.txt\"\ntouch \"$2/restart_1\"\n"
                "while :; do sleep 0.01; done\n");
  fs::create_directories(folder.path() / "b c");
  SlurmJob job;
  job.folder = folder.path();
  job.ids = {"a", "b c"};
  job.command = {folder.path() / "stub"};
  write_program(folder.path() / "cases.sh", cases_script(job));
  const PathWith path(folder.path());
  setenv("SLURM_ARRAY_JOB_ID", "7", 1);
  setenv("SLURM_ARRAY_TASK_ID", "1", 1);
  const pid_t task = fork();
  if (task == 0) {
    if (chdir(folder.path().c_str()) == 0) execlp("bash", "bash", "cases.sh", nullptr);
    _exit(127);
  }
  ASSERT_TRUE(comes_true([&] { return fs::exists(folder.path() / "b c/restart_1"); }, 10));
  kill(task, SIGUSR1);
  int status = 0;
  waitpid(task, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(text_of(folder.path() / "asked.txt"), "requeue 7_1\n");
  EXPECT_EQ(text_of(folder.path() / "b c/words.txt"), "--case b c\n");
}

TEST(Slurm, IsToldThatThereIsNoneOrThatItRefuses)
{
  const TemporaryFolder folder;
  prepare_small_cases(folder.path());
  {
    // Nothing but this folder: no sbatch, whatever is installed.
    const std::string before = getenv("PATH");
    setenv("PATH", folder.path().c_str(), 1);
    const Outcome outcome = RunningCommand(folder.path(), "out", on_cluster).end();
    setenv("PATH", before.c_str(), 1);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_TRUE(outcome.says("encase run: --slurm needs the program 'sbatch', found none"))
        << outcome.output;
  }
  write_program(folder.path() / "sbatch", "echo 'sbatch: error: Invalid account' >&2\nexit 1\n");
  const PathWith path(folder.path());
  const Outcome outcome = RunningCommand(folder.path(), "out", on_cluster).end();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(
      outcome.says("found 'sbatch: error: Invalid account', write what the site asks for "
                   "with --slurm-option"))
      << outcome.output;
}
