// SPDX-License-Identifier: GPL-2.0-only
#include "runner/slurm_job.h"

#include "core/input_error.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

SlurmJob two_cases()
{
  SlurmJob job;
  job.name = "densities";
  job.folder = "/home/user/my runs/densities";
  job.ids = {"d_90", "d_40"};
  job.command = {"/opt/encase", "run", "--out", "/home/user/my runs/densities", "--resume"};
  job.report = {"/opt/encase", "run", "--report-only"};
  job.ranks = 4;
  job.options = {"partition=long", "--time=02:00:00"};
  return job;
}

bool has_line(const std::string& text, const std::string& line)
{
  return ("\n" + text).find("\n" + line + "\n") != std::string::npos;
}

}  // namespace

TEST(SlurmJob, HasATaskForEachCaseAndTheOptionsOfTheSite)
{
  const std::string script = cases_script(two_cases());
  EXPECT_EQ(script.rfind("#!/bin/bash\n", 0), 0u);
  for (const char* line :
       {"#SBATCH --array=0-1", "#SBATCH --ntasks=4", "#SBATCH --requeue",
        "#SBATCH --signal=B:USR1@120", "#SBATCH --partition=long", "#SBATCH --time=02:00:00",
        "#SBATCH --output='/home/user/my runs/densities/slurm/case_%a.txt'", "cases=(d_90 d_40)",
        "folder='/home/user/my runs/densities'/$case",
        "/opt/encase run --out '/home/user/my runs/densities' --resume --case \"$case\" &"})
    EXPECT_TRUE(has_line(script, line)) << line << "\n" << script;
  EXPECT_EQ(script.find("ENCASE_SOURCE"), std::string::npos);
}

// sbatch reads options up to the first line that is a command.
TEST(SlurmJob, HasItsOptionsBeforeItsFirstCommand)
{
  const std::string script = cases_script(two_cases());
  EXPECT_LT(script.rfind("#SBATCH"), script.find("cases=("));
}

TEST(SlurmJob, RunsAsManyTasksAtOnceAsIsAsked)
{
  SlurmJob job = two_cases();
  job.jobs = 1;
  EXPECT_TRUE(has_line(cases_script(job), "#SBATCH --array=0-1%1"));
}

TEST(SlurmJob, MakesTheReportOnOneRank)
{
  SlurmJob job = two_cases();
  job.source = "/home/user/it's mine";
  const std::string script = report_script(job);
  for (const char* line :
       {"#SBATCH --ntasks=1", "#SBATCH --partition=long",
        "export ENCASE_SOURCE='/home/user/it'\\''s mine'", "exec /opt/encase run --report-only"})
    EXPECT_TRUE(has_line(script, line)) << line << "\n" << script;
  EXPECT_EQ(script.find("--array"), std::string::npos);
}

TEST(SlurmJob, RefusesWhatIsNoOptionAndWhatItGivesItself)
{
  for (const char* bad : {"", "-p long", "partition long", "time=1\n#SBATCH --x", "--", "p"})
    EXPECT_THROW(sbatch_line(bad), InputError) << bad;
  for (const char* own : {"array=0-3", "--dependency=afterok:3", "nodes=2"})
    EXPECT_THROW(sbatch_line(own), InputError) << own;
  EXPECT_EQ(sbatch_line("exclusive"), "#SBATCH --exclusive");
}
