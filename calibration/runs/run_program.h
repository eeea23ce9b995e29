// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "config/calibration_config.h"
#include "runner/places.h"
#include "runner/series.h"
#include "runs/run_store.h"

#include <functional>

namespace encased_column {

/// A run that is to be made.
struct PlannedRun {
  RunKey key;
  Case row;            ///< of the file of cases
  Settings variables;  ///< all that differ from the deck: of the row, of all cases, of the point

  /// "p0012_r1_plain_050", also the name of its folder.
  std::string id() const;
  /// The number that `name` has among the variables; `otherwise` where there is none.
  double number(const std::string& name, double otherwise) const;
};

/// What becomes of the runs of one call.
enum class RunsEnd { made, submitted, stopped };

/// Makes runs, in any order, and tells each result as soon as it is there.
class RunProgram {
 public:
  using Tell = std::function<void(const PlannedRun&, const RunResult&)>;
  virtual ~RunProgram() = default;
  virtual RunsEnd make(const std::vector<PlannedRun>& runs, const Tell& tell) = 0;
};

/// `encase run` on decks, in `folder`/runs. With `slurm` its jobs are submitted, no more.
std::unique_ptr<RunProgram> encase_program(const CalibrationConfig& config, const Places& places,
                                           const std::filesystem::path& folder, bool slurm);

/// A user's program, started in `folder`/runs/ID for each run with the words NAME=VALUE behind its
/// own. It leaves curve.csv there, as a curve of the laboratory, and may leave values.csv with the
/// columns quantity and value (SI). Several at once, as `jobs` says.
std::unique_ptr<RunProgram> command_program(const CalibrationConfig& config,
                                            const std::filesystem::path& folder);

/// The formula of run_formula().
std::unique_ptr<RunProgram> formula_program();

}  // namespace encased_column
