// SPDX-License-Identifier: GPL-2.0-only
#include "stages/calibration.h"

#include "core/input_error.h"
#include "search/identifiability.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

namespace {

constexpr double same_point = 1e-9;  // of the unit cube

int last_round(const std::vector<StoredPoint>& points)
{
  int last = 0;
  for (const StoredPoint& one : points) last = std::max(last, one.round);
  return last;
}

long runs_for(const std::vector<StoredPoint>& points, std::size_t cases)
{
  long runs = 0;
  for (const StoredPoint& one : points) runs += one.repeats * static_cast<long>(cases);
  return runs;
}

/// Those of the rounds up to `round`.
std::vector<StoredPoint> up_to(std::vector<StoredPoint> points, int round)
{
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const StoredPoint& one) { return one.round > round; }),
               points.end());
  return points;
}

}  // namespace

Calibration::Calibration(const CalibrationConfig& config, std::vector<Case> rows, RunStore& store,
                         std::ostream& out)
    : config_(config),
      rows_(std::move(rows)),
      store_(store),
      out_(out),
      outputs_(outputs_of(config.targets))
{
}

RunTable Calibration::table() const
{
  return table_of(config_, outputs_, store_.points(), store_.runs());
}

RunsEnd Calibration::run(RunProgram& program)
{
  store_.identify(identity_of(config_, rows_));
  if (store_.points().empty()) {
    const std::vector<StoredPoint> first = first_points(config_);
    const long needed = runs_for(first, rows_.size());
    if (needed > config_.budget)
      throw InputError("'budget' must leave room for the " + std::to_string(needed) +
                       " runs of the design, found " + std::to_string(config_.budget) +
                       ", write a larger one or fewer 'points'");
    store_.add_points(first);
  }
  add_known();
  // What a kill has left of a round is run first.
  for (;;) {
    const RunsEnd end = make_runs(program);
    if (end != RunsEnd::made) return end;
    const int round = last_round(store_.points());
    const Round state = state_of(round);
    out_ << (round ? "Round " + std::to_string(round) : std::string("Design")) << ": " << state.runs
         << " runs, best mismatch " << in_words(state.best)
         << (state.met ? ", all targets met" : "") << std::endl;
    if (state.met || round >= config_.search.rounds) return RunsEnd::made;
    const long next =
        static_cast<long>(rows_.size()) * (config_.design.repeats + config_.search.candidates - 1);
    if (runs_for(store_.points(), rows_.size()) + next > config_.budget) return RunsEnd::made;
    add_round(round + 1);
  }
}

void Calibration::add_known()
{
  std::vector<StoredPoint> points = store_.points(), added;
  const int round = last_round(points);
  for (const Eigen::VectorXd& known : config_.known) {
    const bool there = std::any_of(points.begin(), points.end(), [&](const StoredPoint& one) {
      return one.stage == "known" && (one.point - known).norm() < same_point;
    });
    if (there) continue;
    added.push_back({0, "known", round, config_.design.repeats, known});
    points.push_back(added.back());
  }
  if (added.empty()) return;
  const long needed = runs_for(points, rows_.size());
  if (needed > config_.budget)
    throw InputError("'budget' must leave room for the points of 'known', found " +
                     std::to_string(config_.budget) + " where all are " + std::to_string(needed) +
                     " runs, write a larger one");
  store_.add_points(added);
}

RunsEnd Calibration::make_runs(RunProgram& program)
{
  const std::map<RunKey, RunResult> known = store_.runs();
  std::vector<PlannedRun> missing;
  for (PlannedRun& run : runs_of(config_, rows_, store_.points()))
    if (!known.count(run.key)) missing.push_back(std::move(run));
  if (missing.empty()) return RunsEnd::made;
  out_ << "Runs to make: " << missing.size() << std::endl;
  return program.make(missing, [&](const PlannedRun& run, const RunResult& result) {
    store_.record(run.key, result);
    if (!result.good())
      out_ << "Run " << run.id() << " failed and is left out: " << result.problem << std::endl;
  });
}

Round Calibration::state_of(int number) const
{
  const std::vector<StoredPoint> points = up_to(store_.points(), number);
  std::map<RunKey, RunResult> runs = store_.runs();
  for (auto one = runs.begin(); one != runs.end();)
    one = static_cast<std::size_t>(one->first.point) < points.size() ? std::next(one)
                                                                     : runs.erase(one);
  Round state{number, static_cast<long>(runs.size()), 0.0, false};
  const RunTable table = table_of(config_, outputs_, points, runs);
  const std::vector<Goal> goals = goals_of_means(table);
  const auto best = best_point(table, goals, config_.design.repeats);
  if (!best) return state;
  state.best = mismatch(table.mean_at(*best), goals);
  // Met by chance is not met: it takes all packings.
  for (const StoredPoint& one : points)
    state.met = state.met || (table.packings_at(one.id) >= config_.design.repeats &&
                              all_met(table.mean_at(one.id), goals));
  return state;
}

std::vector<Goal> Calibration::goals_of_means(const RunTable& table) const
{
  std::vector<Goal> goals = goals_of(outputs_);
  for (std::size_t n = 0; n < goals.size(); ++n) {
    const Data data = table.data_of(outputs_[n], static_cast<Eigen::Index>(n));
    goals[n].deviation = combined_deviation(
        goals[n].tolerance,
        packing_scatter(data, goals[n].value) / std::sqrt(1.0 * config_.design.repeats), 0.0);
  }
  return goals;
}

void Calibration::add_round(int number)
{
  const RunTable known = table();
  const Fitted fitted = fit_outputs(config_, outputs_, known);
  const auto seed = config_.design.seed + static_cast<unsigned>(number);
  std::vector<StoredPoint> added;
  for (const Eigen::VectorXd& point : candidates(config_, fitted, known, seed))
    added.push_back({0, "candidate", number, added.empty() ? config_.design.repeats : 1, point});
  store_.add_points(added);
}

Findings Calibration::findings() const
{
  Findings found;
  found.outputs = outputs_;
  found.points = store_.points();
  found.runs = store_.runs();
  found.table = table();
  found.fitted = fit_outputs(config_, outputs_, found.table);
  found.sensitivities = sensitivities(config_, found.table, found.points);
  found.posterior = posterior_of(config_, found.fitted);
  std::vector<std::string> names;
  for (const Parameter& one : config_.space.parameters()) names.push_back(one.name);
  found.not_told = what_is_not_told(found.posterior, names);
  if (config_.search.cost)
    candidates(config_, found.fitted, found.table, config_.design.seed, &found.front);
  for (int round = 0; round <= last_round(found.points); ++round)
    found.rounds.push_back(state_of(round));
  const auto best = best_point(found.table, goals_of_means(found.table), config_.design.repeats);
  if (!best)
    throw InputError("a calibration takes one point with all cases run, found none, see why runs " +
                     std::string("failed in 'runs.sqlite'"));
  found.best = *best;
  found.values = found.table.mean_at(found.best);
  found.met = all_met(found.values, found.fitted.goals);
  found.end =
      found.rounds.back().met
          ? "All targets are met."
          : (last_round(found.points) >= config_.search.rounds
                 ? "Not all targets are met after the last round of candidates."
                 : "Not all targets are met, and the budget leaves no round of candidates.");
  return found;
}

}  // namespace encased_column
