// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// What lies in the folder of a case before it is run.
struct FolderState {
  bool begun = false;      ///< it has a case.json
  bool finished = false;   ///< and was run to its end
  std::string failed;      ///< why it ended before, if not by a signal; empty: it did not fail
  std::string unreadable;  ///< what is wrong with its case.json; empty if nothing is
  std::string there,
      now;  ///< first variable that was asked for otherwise; empty if all are the same
  std::vector<int> whole, broken;  ///< stages whose restart file is whole, and whose is not
};

/// What the user wants of cases that were run before.
struct Wishes {
  bool keep = false;
  bool resume = false;
  bool leave_failed = false;  ///< what failed with the same variables stays as it is
};

enum class Action { fresh, keep, resume, leave, refuse };

struct Decision {
  Action action = Action::fresh;
  int stage = 0;         ///< to go on in
  std::string sentence;  ///< for the user; empty if there is nothing to say
};

/// What becomes of case `id` in the folder `folder`.
Decision decide(const std::string& id, const std::string& folder, const FolderState& state,
                const Wishes& wishes);

}  // namespace encased_column
