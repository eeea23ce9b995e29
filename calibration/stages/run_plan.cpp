// SPDX-License-Identifier: GPL-2.0-only
#include "stages/run_plan.h"

#include "core/input_error.h"
#include "runner/text_file.h"
#include "space/morris.h"

#include <cstdio>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

/// As many digits as tell a double from its neighbour, no more than needed.
std::string digits(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string in_lines(const Settings& settings)
{
  std::string text;
  for (const auto& [name, value] : settings) text += name + "=" + value + "\n";
  return text;
}

}  // namespace

std::vector<Case> rows_of_cases(const CalibrationConfig& config, const Places& places)
{
  const fs::path ours = places.inputs / "series.csv";
  const fs::path file = config.runs.cases_file.empty() ? ours : config.runs.cases_file;
  const std::vector<Case> all = read_series(file, shown(file));
  std::vector<Case> rows;
  for (const std::string& name : config.runs.cases) {
    std::vector<std::string> ids;
    for (const Case& one : all) {
      ids.push_back(one.id);
      if (one.id == name) rows.push_back(one);
    }
    if (rows.empty() || rows.back().id != name)
      throw InputError("unknown case '" + name + "' in 'cases' of '" + shown(config.file) +
                       "', expected one of: " + joined(ids));
    // A deck of the user's lies beside the file of cases, which a copy of its rows does not.
    if (rows.back().deck.find_first_of("/.") != std::string::npos)
      rows.back().deck = fs::absolute(file.parent_path() / rows.back().deck).lexically_normal();
  }
  return rows;
}

std::string identity_of(const CalibrationConfig& config, const std::vector<Case>& rows)
{
  std::string text;
  for (const Parameter& one : config.space.parameters())
    text += one.name + " from " + digits(one.low) + " to " + digits(one.high) +
            (one.logarithmic ? ", log" : "") +
            (one.also.empty() ? "" : ", also " + joined(one.also)) + "\n";
  for (const Case& row : rows)
    text += "case " + row.id + " of deck " + row.deck + "\n" + in_lines(row.variables);
  text += in_lines(config.runs.set) + "resolution " + config.runs.resolution + "\n";
  text += "program " +
          (config.runs.kind == RunKind::encase    ? std::string("encase")
           : config.runs.kind == RunKind::formula ? std::string("formula")
                                                  : joined(config.runs.command)) +
          "\n";
  return text + "seed " + std::to_string(config.design.seed) + ", repeats " +
         std::to_string(config.design.repeats) + "\n";
}

std::vector<StoredPoint> first_points(const CalibrationConfig& config)
{
  const DesignPlan& plan = config.design;
  std::vector<StoredPoint> points;
  const Eigen::MatrixXd design =
      space_filling_design(plan.kind, plan.points, config.space.size(), plan.seed);
  for (int n = 0; n < plan.points; ++n)
    points.push_back(
        {0, "design", 0, n < plan.repeated ? plan.repeats : 1, design.row(n).transpose()});
  const Eigen::MatrixXd ways =
      morris_plan(plan.morris_ways, config.space.size(), usual_morris_levels, plan.seed).points;
  for (Eigen::Index n = 0; n < ways.rows(); ++n)
    points.push_back({0, "morris", 0, 1, ways.row(n).transpose()});
  return points;
}

int packing_seed(const CalibrationConfig& config, const RunKey& key)
{
  return static_cast<int>(config.design.seed) + key.point * config.design.repeats + key.repeat;
}

std::vector<PlannedRun> runs_of(const CalibrationConfig& config, const std::vector<Case>& rows,
                                const std::vector<StoredPoint>& points)
{
  std::vector<PlannedRun> runs;
  for (const StoredPoint& point : points) {
    const std::vector<double> values = config.space.values(point.point);
    for (int repeat = 0; repeat < point.repeats; ++repeat)
      for (const Case& row : rows) {
        PlannedRun run{{point.id, repeat, row.id}, row, {}};
        std::map<std::string, std::string> seen;  // what comes later counts
        for (const Settings& part : {row.variables, config.runs.set})
          for (const auto& [name, value] : part) seen[name] = value;
        for (int i = 0; i < config.space.size(); ++i) {
          const std::string value = digits(values[static_cast<std::size_t>(i)]);
          seen[config.space[i].name] = value;
          for (const std::string& other : config.space[i].also) seen[other] = value;
        }
        seen["seed"] = std::to_string(packing_seed(config, run.key));
        run.variables.assign(seen.begin(), seen.end());
        runs.push_back(std::move(run));
      }
  }
  return runs;
}

}  // namespace encased_column
