// SPDX-License-Identifier: GPL-2.0-only
#include "runner/resume_decision.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

FolderState begun(std::vector<int> whole, std::vector<int> broken = {})
{
  FolderState state;
  state.begun = true;
  state.whole = std::move(whole);
  state.broken = std::move(broken);
  return state;
}

Decision resumed(const FolderState& state)
{
  return decide("a", "runs/x", state, {false, true});
}

}  // namespace

TEST(ResumeDecision, BeginsWhereNothingLies)
{
  for (const bool keep : {false, true})
    for (const bool resume : {false, true}) {
      const Decision d = decide("a", "runs/x", {}, {keep, resume});
      EXPECT_EQ(d.action, Action::fresh);
      EXPECT_EQ(d.sentence, "");
    }
}

TEST(ResumeDecision, GoesOnFromTheLatestWholeFile)
{
  const Decision d = resumed(begun({1, 2, 3}));
  EXPECT_EQ(d.action, Action::resume);
  EXPECT_EQ(d.stage, 3);
  EXPECT_EQ(d.sentence, "Case a goes on in stage 3");
}

TEST(ResumeDecision, GoesOnFromAnOlderFileWhereTheLatestIsBroken)
{
  const Decision d = resumed(begun({1, 2}, {3}));
  EXPECT_EQ(d.action, Action::resume);
  EXPECT_EQ(d.stage, 2);
  EXPECT_EQ(d.sentence, "Case a goes on in stage 2, restart_3 is cut off or of another version");
}

TEST(ResumeDecision, BeginsAgainWithoutAWholeFile)
{
  EXPECT_EQ(resumed(begun({})).action, Action::fresh);
  EXPECT_EQ(resumed(begun({})).sentence, "Case a begins again, it has left no restart file yet");
  EXPECT_EQ(resumed(begun({}, {1})).sentence,
            "Case a begins again, restart_1 is cut off or of another version");
}

TEST(ResumeDecision, KeepsWhatHasFinishedWithTheSameVariables)
{
  FolderState state = begun({4});
  state.finished = true;
  EXPECT_EQ(resumed(state).action, Action::keep);
  EXPECT_EQ(decide("a", "runs/x", state, {true, false}).action, Action::keep);
  EXPECT_EQ(decide("a", "runs/x", state, {}).action, Action::fresh);
}

TEST(ResumeDecision, RefusesToGoOnWithOtherVariables)
{
  FolderState state = begun({4});
  state.there = "sigma3=50e3";
  state.now = "sigma3=60e3";
  for (const bool finished : {false, true}) {
    state.finished = finished;
    EXPECT_EQ(resumed(state).action, Action::refuse);
    EXPECT_EQ(resumed(state).sentence,
              "case 'a' in 'runs/x' was begun with other variables, found sigma3=50e3 there and "
              "sigma3=60e3 now, give the same --resolution and --set or another --name");
  }
}

TEST(ResumeDecision, SaysThatResultsOfOtherVariablesGo)
{
  FolderState state = begun({4});
  state.finished = true;
  EXPECT_EQ(decide("a", "runs/x", state, {}).sentence, "") << "the same results come again";
  state.there = "sigma3=50e3";
  state.now = "sigma3=60e3";
  EXPECT_EQ(decide("a", "runs/x", state, {}).sentence,
            "Case a begins again with other variables; its results go (another --name would keep "
            "them)");
}

TEST(ResumeDecision, SaysThatAnUnfinishedRunGoes)
{
  EXPECT_EQ(decide("a", "runs/x", begun({1}), {}).sentence,
            "Case a begins again; its unfinished run and restart files go (--resume would go on "
            "with them)");
}

TEST(ResumeDecision, OfASeriesRetriesNothingSilently)
{
  FolderState state = begun({3});
  state.failed = "ERROR: lost grains";
  const Decision left = decide("a", "runs/x", state, {false, true, true});
  EXPECT_EQ(left.action, Action::leave);
  EXPECT_EQ(left.sentence,
            "Case a failed before and is left so (--retry would run it): ERROR: lost grains");
  EXPECT_EQ(resumed(state).action, Action::resume);
  EXPECT_EQ(resumed(state).sentence, "Case a failed before and goes on in stage 3");
  state.there = "sigma3=50e3";
  state.now = "sigma3=60e3";
  EXPECT_EQ(decide("a", "runs/x", state, {false, true, true}).action, Action::refuse);
}

TEST(ResumeDecision, RefusesARecordItCannotReadOnlyWhereItMustGoOn)
{
  FolderState state = begun({4});
  state.unreadable = "'case.json' is no JSON";
  EXPECT_EQ(decide("a", "runs/x", state, {}).action, Action::fresh);
  EXPECT_EQ(resumed(state).action, Action::refuse);
}
