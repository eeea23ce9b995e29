// SPDX-License-Identifier: GPL-2.0-only
#include "stages/analysis.h"

#include "core/input_error.h"
#include "search/genetic_search.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace encased_column {

namespace {

constexpr Eigen::Index fewest_runs = 10;
constexpr int resamples = 100;
constexpr double about_as_good = 4.0;  // of the mismatch: two standard deviations of one parameter

FittedOutput fit_output(const SearchPlan& plan, unsigned seed, const Goal& goal, const Data& data)
{
  if (data.size() < fewest_runs)
    throw InputError("a surrogate takes " + std::to_string(fewest_runs) + " runs at least, found " +
                     std::to_string(data.size()) + " that gave '" + goal.name +
                     "', see why others failed in the report or with 'sqlite3 runs.sqlite'");
  FittedOutput fitted;
  for (const SurrogateKind kind : plan.surrogates)
    fitted.validations.push_back(cross_validate(kind, data, plan.folds, seed));
  const Validation& best = better_of(fitted.validations);
  fitted.kind = best.kind;
  fitted.surrogate = fit_of(best.kind, data, seed)(data);
  fitted.error = error_near(best, data, goal.value);
  fitted.scatter = packing_scatter(data, goal.value);
  fitted.runs = data.size();
  return fitted;
}

double distance_to(const Eigen::MatrixXd& points, const Eigen::RowVectorXd& point)
{
  return (points.rowwise() - point).rowwise().norm().minCoeff();
}

}  // namespace

Eigen::VectorXd Fitted::values(const Eigen::VectorXd& point) const
{
  Eigen::VectorXd all(static_cast<Eigen::Index>(outputs.size()));
  for (std::size_t n = 0; n < outputs.size(); ++n)
    all[static_cast<Eigen::Index>(n)] = outputs[n].surrogate->value(point);
  return all;
}

double Fitted::mismatch_at(const Eigen::VectorXd& point, const std::vector<Goal>& from) const
{
  double sum = 0.0;
  for (std::size_t n = 0; n < outputs.size(); ++n)
    if (from[n].weight > 0.0)
      sum += from[n].weight *
             std::pow((outputs[n].surrogate->value(point) - from[n].value) / from[n].deviation, 2);
  return sum;
}

double packing_scatter(const Data& data, double value)
{
  if (!data.proportional) return pooled_scatter(data.values, data.groups);
  return std::abs(value) * pooled_scatter(data.logarithms().values, data.groups);
}

Fitted fit_outputs(const CalibrationConfig& config, const std::vector<Output>& outputs,
                   const RunTable& table)
{
  Fitted fitted;
  fitted.goals = goals_of(outputs);
  fitted.sought = fitted.goals;
  for (std::size_t n = 0; n < outputs.size(); ++n) {
    const Data data = table.data_of(outputs[n], static_cast<Eigen::Index>(n));
    fitted.outputs.push_back(fit_output(config.search, config.design.seed, fitted.goals[n], data));
    const FittedOutput& one = fitted.outputs.back();
    fitted.goals[n].deviation =
        combined_deviation(fitted.goals[n].tolerance, one.scatter, one.error);
    // What is left of the surrogate's error where the scatter of single packings is taken out.
    const double square = one.error * one.error - one.scatter * one.scatter;
    fitted.sought[n].deviation =
        combined_deviation(fitted.sought[n].tolerance, 0.0, std::sqrt(std::max(square, 0.0)));
  }
  const Data seconds = table.data_of(table.seconds.array().log().matrix());
  if (config.search.cost && seconds.size() >= fewest_runs)
    fitted.log_seconds = fit_of(SurrogateKind::polynomial, seconds, config.design.seed)(seconds);
  return fitted;
}

std::vector<Sensitivity> sensitivities(const CalibrationConfig& config, const RunTable& table,
                                       const std::vector<StoredPoint>& points)
{
  const MorrisPlan plan = morris_plan(config.design.morris_ways, config.space.size(),
                                      usual_morris_levels, config.design.seed);
  std::vector<Sensitivity> all;
  for (Eigen::Index column = 0; column < table.values.cols(); ++column) {
    const Data data = table.data_of(table.values.col(column));
    Sensitivity one{sobol_indices(fit_polynomial(data), data, resamples, config.design.seed), {}};
    Eigen::VectorXd values(plan.points.rows());
    Eigen::Index row = 0;
    for (const StoredPoint& point : points)
      if (point.stage == "morris" && row < values.size())
        values[row++] = table.mean_at(point.id)[column];
    if (row == values.size() && row > 0) one.morris = morris_effects(plan, values);
    all.push_back(std::move(one));
  }
  return all;
}

std::vector<Eigen::VectorXd> candidates(const CalibrationConfig& config, const Fitted& fitted,
                                        const RunTable& table, unsigned seed,
                                        std::vector<Found>* front)
{
  const CubeFunction objective = [&](const Eigen::VectorXd& point) {
    return fitted.mismatch_at(point, fitted.sought);
  };
  const int dimensions = config.space.size();
  const auto wanted = static_cast<std::size_t>(config.search.candidates);
  const Found best = genetic_search(objective, dimensions, seed);
  std::vector<Eigen::VectorXd> chosen{best.point};
  if (fitted.log_seconds) {
    const CubeFunction cost = [&](const Eigen::VectorXd& point) {
      return fitted.log_seconds->value(point);
    };
    const std::vector<Found> found = pareto_search(objective, cost, dimensions, seed);
    const Found* cheapest = nullptr;
    for (const Found& one : found)
      if (one.values[0] <= best.values[0] + about_as_good &&
          (!cheapest || one.values[1] < cheapest->values[1]))
        cheapest = &one;
    if (cheapest && chosen.size() < wanted) chosen.push_back(cheapest->point);
    if (front) *front = found;
  }
  if (chosen.size() >= wanted) return chosen;
  const Posterior posterior = sample_posterior(
      [&](const Eigen::VectorXd& point) { return -0.5 * fitted.mismatch_at(point, fitted.goals); },
      best.point, 400, seed);
  Eigen::MatrixXd known = table.points;
  while (chosen.size() < wanted) {
    known.conservativeResize(known.rows() + 1, dimensions);
    known.row(known.rows() - 1) = chosen.back().transpose();
    Eigen::Index farthest = 0;
    double distance = -1.0;
    for (Eigen::Index row = 0; row < posterior.points.rows(); ++row) {
      const double found = distance_to(known, posterior.points.row(row));
      if (found <= distance) continue;
      distance = found;
      farthest = row;
    }
    chosen.push_back(posterior.points.row(farthest).transpose());
  }
  return chosen;
}

Posterior posterior_of(const CalibrationConfig& config, const Fitted& fitted)
{
  const CubeFunction objective = [&](const Eigen::VectorXd& point) {
    return fitted.mismatch_at(point, fitted.goals);
  };
  const Found best = genetic_search(objective, config.space.size(), config.design.seed);
  return sample_posterior([&](const Eigen::VectorXd& point) { return -0.5 * objective(point); },
                          best.point, config.search.samples, config.design.seed);
}

std::optional<int> best_point(const RunTable& table, const std::vector<Goal>& goals, int repeats)
{
  for (const int enough : {repeats, 1}) {
    std::optional<int> best;
    double least = HUGE_VAL;
    for (const int id : std::set<int>(table.ids.begin(), table.ids.end())) {
      if (table.packings_at(id) < enough) continue;
      const double found = mismatch(table.mean_at(id), goals);
      if (found >= least) continue;
      least = found;
      best = id;
    }
    if (best) return best;
  }
  return std::nullopt;
}

}  // namespace encased_column
