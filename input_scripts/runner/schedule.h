#pragma once

namespace encased_column {

/// How cases share a machine.
struct Schedule {
  int ranks = 1;  ///< of MPI, each case
  int jobs = 1;   ///< cases at once
};

/// What finishes `cases` soonest on `cores`; `ranks` and `jobs` hold what is given, 0 what is free.
///
/// Cases side by side are perfectly parallel but leave cores idle in the last round; 1, 2, 3 and 4
/// ranks run a case 1, 1.85, 2.6 and 3.3 times as fast (measured at `paper`).
Schedule best_schedule(int cases, int cores, int ranks = 0, int jobs = 0);

}  // namespace encased_column
