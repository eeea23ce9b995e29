// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/time_left.h"

#include <string>
#include <vector>

namespace encased_column {

/// How far a case has come.
struct Progress {
  double fraction = 0.0;  ///< of its whole work, 0 to 1
  std::string stage = "starting";
};

/// Reads the lines a deck appends to its progress.txt, the last one that can be read counts:
///
///     0.42 shear                                   that fraction of the whole
///     0.15 0.30 consolidation ratio 3e-3 1e-5      a stage from the first fraction to the second,
///                                                  whose ratio of now falls to its limit
///
/// A ratio falls by orders of magnitude, so its stage moves with its logarithm, between the largest
/// one since the stage began and the limit. Behind the largest one it never goes back, though the
/// ratio swings.
Progress read_progress(const std::string& text);

/// "3 h 05 min", "12 min", "45 s".
std::string in_time(double seconds);

struct RunningCase {
  std::string id;
  Progress progress;
};

/// A line for each running case with its stage and percent, and one for the whole: cases that have
/// ended, percent of the work, time left. `clocks` are those of all cases, `jobs` run at once.
std::vector<std::string> progress_lines(const std::vector<RunningCase>& running,
                                        const std::vector<CaseClock>& clocks, int jobs);

/// What is left where a signal has ended the whole.
struct Left {
  std::vector<std::pair<std::string, int>> resumable;  ///< case and the stage it goes on from
  std::vector<std::string> begin_again;                ///< cases without a restart file
  bool tables_missing = false;  ///< all cases have ended, their tables are not made
  bool series = false;          ///< the same command goes on, without --resume
};

/// The last line after a signal: what the next start goes on with, and nothing else.
std::string stopped_line(const Left& left);

}  // namespace encased_column
