// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "search/posterior.h"
#include "space/morris.h"
#include "stages/outputs.h"
#include "surrogate/cross_validation.h"
#include "surrogate/sobol_indices.h"

#include <memory>
#include <optional>

namespace encased_column {

/// A surrogate of each output, the better of those tried.
struct FittedOutput {
  std::vector<Validation> validations;  ///< of each kind, side by side
  SurrogateKind kind = SurrogateKind::polynomial;
  std::shared_ptr<const Surrogate> surrogate;
  double error = 0.0;     ///< where the laboratory's value is, see error_near()
  double scatter = 0.0;   ///< between packings of one point
  Eigen::Index runs = 0;  ///< learnt from
};

/// All that is known of the outputs with the runs so far.
struct Fitted {
  std::vector<FittedOutput> outputs;
  std::vector<Goal> goals;                       ///< with their deviations
  std::shared_ptr<const Surrogate> log_seconds;  ///< of all cases together; empty without times

  Eigen::VectorXd values(const Eigen::VectorXd& point) const;
  double mismatch_at(const Eigen::VectorXd& point) const;
};

/// Fits and validates surrogates of all outputs. Throws InputError where an output has fewer than
/// ten runs.
Fitted fit_outputs(const CalibrationConfig& config, const std::vector<Output>& outputs,
                   const RunTable& table);

/// What the parameters do to an output.
struct Sensitivity {
  SobolIndices sobol;
  std::vector<MorrisEffect> morris;  ///< empty without Morris's ways
};
std::vector<Sensitivity> sensitivities(const CalibrationConfig& config, const RunTable& table,
                                       const std::vector<StoredPoint>& points);

/// Points that are worth a run: first the best one of the genetic search, then, with cost as an
/// objective, the cheapest one of those about as good, then points of the posterior far from all
/// that has run. `front` takes what the second objective gave.
std::vector<Eigen::VectorXd> candidates(const CalibrationConfig& config, const Fitted& fitted,
                                        const RunTable& table, unsigned seed,
                                        std::vector<Found>* front = nullptr);

/// The posterior of all parameters, from the best point of the surrogates.
Posterior posterior_of(const CalibrationConfig& config, const Fitted& fitted);

/// The point, among those that have run with all cases, whose mean comes closest to the goals. A
/// point with fewer than `repeats` packings may be good by luck: its mismatch counts one more for
/// each that it lacks. Nothing if no point has run.
std::optional<int> best_point(const RunTable& table, const std::vector<Goal>& goals, int repeats);

}  // namespace encased_column
