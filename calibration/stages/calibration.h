// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "stages/analysis.h"
#include "stages/run_plan.h"

#include <ostream>

namespace encased_column {

/// A round of candidates, as the report tells it.
struct Round {
  int number = 0;     ///< from 1; 0 is the design
  long runs = 0;      ///< of cases, so far
  double best = 0.0;  ///< mismatch of the best point so far
  bool met = false;   ///< all targets
};

/// All that a calibration has found.
struct Findings {
  std::vector<Output> outputs;
  std::vector<StoredPoint> points;
  std::map<RunKey, RunResult> runs;
  RunTable table;
  Fitted fitted;
  std::vector<Sensitivity> sensitivities;
  Posterior posterior;
  std::vector<std::string> not_told;  ///< what the data cannot tell
  std::vector<Found> front;           ///< mismatch and log of the time; empty without cost
  std::vector<Round> rounds;
  int best = 0;            ///< id of the point
  Eigen::VectorXd values;  ///< of the outputs there, mean of its packings
  bool met = false;        ///< all targets, there
  std::string end;         ///< why it ended: a sentence
};

/// Stages of a calibration: design, runs, then rounds of surrogates, search and runs until the
/// targets are met or the budget ends. The store is all that it remembers, and every choice is the
/// same for the same store, so that it goes on wherever it was ended.
class Calibration {
 public:
  Calibration(const CalibrationConfig& config, std::vector<Case> rows, RunStore& store,
              std::ostream& out);

  /// Makes what is missing. Throws InputError for a budget too small or a surrogate without data.
  RunsEnd run(RunProgram& program);
  /// What is known when no run is missing.
  Findings findings() const;

 private:
  RunsEnd make_runs(RunProgram& program);
  /// With the deviations of means over packings.
  std::vector<Goal> goals_of_means(const RunTable& table) const;
  void add_round(int number);
  /// Those that the user names and that are not there yet, to be run next.
  void add_known();
  Round state_of(int number) const;
  RunTable table() const;

  const CalibrationConfig& config_;
  std::vector<Case> rows_;
  RunStore& store_;
  std::ostream& out_;
  std::vector<Output> outputs_;
};

}  // namespace encased_column
