// SPDX-License-Identifier: GPL-2.0-only
#include "runner/resume_decision.h"

#include <algorithm>

namespace encased_column {

namespace {

int latest(const std::vector<int>& stages)
{
  return stages.empty() ? 0 : *std::max_element(stages.begin(), stages.end());
}

std::string damaged(const FolderState& state)
{
  std::string names;
  for (const int stage : state.broken)
    if (stage > latest(state.whole))
      names += (names.empty() ? "" : ", ") + ("restart_" + std::to_string(stage));
  return names;
}

Decision go_on(const std::string& id, const FolderState& state)
{
  const int stage = latest(state.whole);
  const std::string bad = damaged(state);
  const std::string why =
      bad.empty() ? "it has left no restart file yet" : bad + " is cut off or of another version";
  const std::string subject = "Case " + id + (state.failed.empty() ? "" : " failed before and");
  if (stage == 0) return {Action::fresh, 0, subject + " begins again, " + why};
  std::string sentence = subject + " goes on in stage " + std::to_string(stage);
  if (!bad.empty()) sentence += ", " + why;
  return {Action::resume, stage, sentence};
}

}  // namespace

Decision decide(const std::string& id, const std::string& folder, const FolderState& state,
                const Wishes& wishes)
{
  if (!state.begun) return {};
  if (!state.unreadable.empty()) {
    if (!wishes.resume) return {};
    return {Action::refuse, 0,
            state.unreadable + ", or leave --resume out, and case '" + id + "' begins again"};
  }
  const bool same = state.there.empty();
  if (!state.failed.empty() && same && wishes.leave_failed)
    return {Action::leave, 0,
            "Case " + id + " failed before and is left so (--retry would run it): " + state.failed};
  if (state.finished && same && (wishes.keep || wishes.resume))
    return {Action::keep, 0, "Case " + id + " is kept as it is"};
  if (wishes.resume && !same)
    return {Action::refuse, 0,
            "case '" + id + "' in '" + folder + "' was begun with other variables, found " +
                state.there + " there and " + state.now +
                " now, give the same --resolution and --set or another --name"};
  if (state.finished)
    return {Action::fresh, 0,
            same ? ""
                 : "Case " + id +
                       " begins again with other variables; its results go (another --name would "
                       "keep them)"};
  if (wishes.resume) return go_on(id, state);
  if (state.whole.empty()) return {};
  return {Action::fresh, 0,
          "Case " + id +
              " begins again; its unfinished run and restart files go (--resume would go on with "
              "them)"};
}

}  // namespace encased_column
