// SPDX-License-Identifier: GPL-2.0-only
#include "runner/case_table.h"

#include "support/child_program.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace encased_column;
using encased_column::testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

const Deck empty_deck{"trial", "", "", {}, {}, false, false};

CaseOutcome outcome_in(const fs::path& series)
{
  const CaseFolder folder(series / "a", {{"a", "trial", true, {}, "A", ""}, &empty_deck, {}, {}});
  return outcome_of(folder, series / "checks.csv");
}

}  // namespace

TEST(CaseTable, TellsWhatPassedWhatFailedAndWhy)
{
  EXPECT_EQ(case_table({{"plain_050", "passed", ""}, {"own", "failed", "ERROR: lost grains"}}),
            "case       outcome  why\n"
            "plain_050  passed\n"
            "own        failed   ERROR: lost grains\n"
            "1 of 2 passed.\n");
}

TEST(CaseTable, TakesTheOutcomeFromTheFolder)
{
  const TemporaryFolder series;
  EXPECT_EQ(outcome_in(series.path()).outcome, "not run");
  const fs::path folder = series.path() / "a";
  fs::create_directories(folder);
  write_case_record(folder / "case.json", {"a", "trial", "A", "", {}, {}});
  std::ofstream(folder / "progress.txt") << "0.415 shear\n";
  EXPECT_EQ(outcome_in(series.path()).outcome, "stopped");
  EXPECT_EQ(outcome_in(series.path()).why, "in shear, at 41 %");

  CaseFolder(folder, {{"a", "trial", true, {}, "A", ""}, &empty_deck, {}, {}})
      .note_failed("exit code 1, see log\nERROR: lost grains (fix_x.cpp:12)\nLast command\n");
  EXPECT_EQ(outcome_in(series.path()).outcome, "failed");
  EXPECT_EQ(outcome_in(series.path()).why, "ERROR: lost grains (fix_x.cpp:12)");

  fs::remove(folder / "failed");
  std::ofstream(folder / "finished") << "2026\n";
  EXPECT_EQ(outcome_in(series.path()).outcome, "passed");
  std::ofstream(series.path() / "checks.csv") << "test,parameters,check,found,allowed,verdict\n"
                                                 "a,study,\"held, every sample\",0.2,0.01,FAIL\n"
                                                 "a,study,ratio,0.2,0.01,not required\n"
                                                 "b,study,ratio,0.2,0.01,FAIL\n";
  EXPECT_EQ(outcome_in(series.path()).outcome, "checks missed");
  EXPECT_EQ(outcome_in(series.path()).why, "held, every sample: 0.2, allowed 0.01");
}
