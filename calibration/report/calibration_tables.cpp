// SPDX-License-Identifier: GPL-2.0-only
#include "report/calibration_tables.h"

#include "config/units.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

namespace {

std::string share_text(double share)
{
  return fixed(100.0 * share, 0) + " %";
}

}  // namespace

Rows parameter_rows(const CalibrationConfig& config, const Findings& found)
{
  Rows rows{{"parameter", "best", "median", "95 % interval", "range", "spread left",
             "most correlated with"}};
  const Eigen::MatrixXd together = correlations(found.posterior.points);
  const StoredPoint& best = found.points[static_cast<std::size_t>(found.best)];
  for (int i = 0; i < config.space.size(); ++i) {
    const Parameter& one = config.space[i];
    const Eigen::VectorXd column = found.posterior.points.col(i);
    const auto value = [&](double share) {
      return in_usual_unit(config.space.value(i, share), one.unit);
    };
    int partner = -1;
    for (int j = 0; j < config.space.size(); ++j)
      if (j != i && (partner < 0 || std::abs(together(i, j)) > std::abs(together(i, partner))))
        partner = j;
    const double left = std::sqrt(12.0 * (column.array() - column.mean()).square().mean());
    rows.push_back(
        {one.name, value(best.point[i]), value(quantile(column, 0.5)),
         value(quantile(column, 0.025)) + " to " + value(quantile(column, 0.975)),
         value(0.0) + " to " + value(1.0), share_text(left),
         partner < 0 ? "-"
                     : config.space[partner].name + " (" + fixed(together(i, partner), 2) + ")"});
  }
  return rows;
}

Rows target_rows(const Findings& found)
{
  Rows rows{
      {"target", "laboratory", "tolerance", "found", "difference", "scatter", "error", "verdict"}};
  for (std::size_t n = 0; n < found.outputs.size(); ++n) {
    const Output& output = found.outputs[n];
    const Goal& goal = found.fitted.goals[n];
    const FittedOutput& fitted = found.fitted.outputs[n];
    const double value = found.values[static_cast<Eigen::Index>(n)];
    const auto shown_value = [&](double x) { return in_unit_like(x, goal.value, output.unit); };
    const bool met = std::abs(value - goal.value) <= goal.tolerance;
    rows.push_back({goal.name, in_usual_unit(goal.value, output.unit), shown_value(goal.tolerance),
                    in_unit_like(value, goal.value, output.unit, 4),
                    shown_value(value - goal.value), shown_value(fitted.scatter),
                    shown_value(fitted.error),
                    goal.weight == 0.0 ? (met ? "foretold" : "foretold, off")
                    : met              ? "pass"
                                       : "FAIL"});
  }
  return rows;
}

Rows validation_rows(const CalibrationConfig& config, const Findings& found)
{
  Rows rows{{"value"}};
  for (const SurrogateKind kind : config.search.surrogates)
    rows.front().push_back("R2, " + name_of(kind));
  for (const char* heading : {"used", "runs"}) rows.front().push_back(heading);
  for (std::size_t n = 0; n < found.outputs.size(); ++n) {
    const FittedOutput& one = found.fitted.outputs[n];
    std::vector<std::string> row{found.outputs[n].goal.name};
    for (const Validation& each : one.validations) row.push_back(fixed(each.score, 3));
    row.push_back(name_of(one.kind));
    row.push_back(std::to_string(one.runs));
    rows.push_back(row);
  }
  return rows;
}

Rows morris_rows(const CalibrationConfig& config, const Findings& found)
{
  Rows rows{{"value"}};
  for (const Parameter& one : config.space.parameters()) rows.front().push_back(one.name);
  for (std::size_t n = 0; n < found.outputs.size(); ++n) {
    const std::vector<MorrisEffect>& effects = found.sensitivities[n].morris;
    if (effects.empty()) continue;
    std::vector<std::string> row{found.outputs[n].goal.name};
    for (const MorrisEffect& one : effects)
      row.push_back(in_usual_unit(one.mean_size, found.outputs[n].unit, 3) + " ± " +
                    in_usual_unit(one.standard_error, found.outputs[n].unit, 2) + ", " +
                    in_usual_unit(one.deviation, found.outputs[n].unit, 2));
    rows.push_back(row);
  }
  return rows;
}

Rows round_rows(const Findings& found)
{
  Rows rows{{"round", "runs", "mismatch of the best", "targets"}};
  for (const Round& one : found.rounds)
    rows.push_back({std::to_string(one.number), std::to_string(one.runs), fixed(one.best, 2),
                    one.met ? "met" : "not met"});
  return rows;
}

Rows failed_rows(const Findings& found)
{
  Rows rows{{"failed run", "point", "why"}};
  for (const auto& [key, result] : found.runs)
    if (!result.good())
      rows.push_back({key.name + ", packing " + std::to_string(key.repeat),
                      std::to_string(key.point), result.problem});
  return rows;
}

Rows front_rows(const CalibrationConfig& config, const Findings& found)
{
  Rows rows{{"mismatch", "seconds"}};
  for (const Parameter& one : config.space.parameters()) rows.front().push_back(one.name);
  const std::size_t every = std::max<std::size_t>(1, found.front.size() / 10);
  for (std::size_t n = 0; n < found.front.size(); n += every) {
    const Found& one = found.front[n];
    std::vector<std::string> row{fixed(one.values[0], 2), fixed(std::exp(one.values[1]), 1)};
    for (int i = 0; i < config.space.size(); ++i)
      row.push_back(in_usual_unit(config.space.value(i, one.point[i]), config.space[i].unit));
    rows.push_back(row);
  }
  return rows;
}

std::string cost_sentence(const Findings& found)
{
  double seconds = 0.0;
  long failed = 0;
  for (const auto& [key, result] : found.runs) {
    seconds += result.seconds;
    failed += !result.good();
  }
  return std::to_string(found.runs.size()) + " runs, " + std::to_string(failed) +
         " of them failed and left out; " + fixed(seconds / 3600.0, 2) +
         " hours of runs in all, as if one after the other.";
}

}  // namespace encased_column
