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
  std::vector<Goal> goals;   ///< deviations: of one packing, as the laboratory's specimen is one
  std::vector<Goal> sought;  ///< deviations: of the mean over packings, which the search looks for
  std::shared_ptr<const Surrogate> log_seconds;  ///< of all cases together; empty without times

  Eigen::VectorXd values(const Eigen::VectorXd& point) const;
  /// Of what the surrogates foretell, from `goals` or `sought`.
  double mismatch_at(const Eigen::VectorXd& point, const std::vector<Goal>& from) const;
};

/// Standard deviation of one packing about the mean of its point, for a value of about `value`.
double packing_scatter(const Data& data, double value);

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

/// The point, among those that have run with all cases, whose mean comes closest to the goals. One
/// with fewer than `repeats` packings may be good by luck: it counts only where no other has run.
/// Nothing if no point has run.
std::optional<int> best_point(const RunTable& table, const std::vector<Goal>& goals, int repeats);

}  // namespace encased_column
