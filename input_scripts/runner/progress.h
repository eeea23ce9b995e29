#pragma once

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

/// One line: each running case with stage and percent, percent of the whole, time left. `ended` of
/// `all` cases have ended; the clock began `seconds` ago, when cases that went on had brought
/// `brought` cases' worth of work with them.
std::string progress_line(const std::vector<RunningCase>& running, int ended, int all,
                          double seconds, double brought);

/// What is left where a signal has ended the whole.
struct Left {
  std::vector<std::pair<std::string, int>> resumable;  ///< case and the stage it goes on from
  std::vector<std::string> begin_again;                ///< cases without a restart file
  bool tables_missing = false;  ///< all cases have ended, their tables are not made
};

/// The last line after a signal: what --resume goes on with, and nothing else.
std::string stopped_line(const Left& left);

}  // namespace encased_column
