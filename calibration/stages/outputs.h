// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "config/calibration_config.h"
#include "runs/run_store.h"
#include "search/mismatch.h"
#include "surrogate/surrogate.h"

namespace encased_column {

/// One number that is compared with the laboratory: a target, or a curve at one strain.
struct Output {
  Goal goal;
  std::string unit;           ///< SI
  std::size_t target;         ///< its number in the configuration
  double strain = 0.0;        ///< of a curve
  bool proportional = false;  ///< see Quantity
};

/// All numbers of all targets. A curve counts as one target: its strains share its weight.
std::vector<Output> outputs_of(const std::vector<Target>& targets);

std::vector<Goal> goals_of(const std::vector<Output>& outputs);

/// What the runs of one point and packing, by case, give for `output`; not a number where one that
/// it needs is missing or failed.
double output_value(const Output& output, const Target& target,
                    const std::map<std::string, RunResult>& runs);

/// All runs as numbers: a row for each point and packing.
struct RunTable {
  Eigen::MatrixXd points;         ///< of the unit cube
  Eigen::MatrixXd values;         ///< of each output; not a number where there is none
  Eigen::VectorXd seconds;        ///< of all cases together; not a number unless all have run
  std::vector<int> ids, repeats;  ///< of the points, and their packings

  /// The rows that have a value of `column`, as a surrogate learns them.
  Data data_of(const Eigen::VectorXd& column) const;
  /// The same of an output, by its number.
  Data data_of(const Output& output, Eigen::Index column) const;
  /// The mean over packings of all outputs at the point `id`, and how many packings there are with
  /// all cases.
  Eigen::VectorXd mean_at(int id) const;
  int packings_at(int id) const;
};
RunTable table_of(const CalibrationConfig& config, const std::vector<Output>& outputs,
                  const std::vector<StoredPoint>& points, const std::map<RunKey, RunResult>& runs);

}  // namespace encased_column
