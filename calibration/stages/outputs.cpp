// SPDX-License-Identifier: GPL-2.0-only
#include "stages/outputs.h"

#include "analysis/strength.h"
#include "config/quantities.h"
#include "config/units.h"
#include "core/input_error.h"

#include <cmath>
#include <limits>

namespace encased_column {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double strength_value(const Target& target, const std::map<std::string, RunResult>& runs)
{
  std::vector<StressPoint> peaks;
  for (const std::string& name : target.cases) {
    const auto run = runs.find(name);
    if (run == runs.end() || !run->second.good()) return none;
    peaks.push_back({run->second.values.at("peak_p"), run->second.values.at("peak_q")});
  }
  try {
    const Strength strength = strength_of(fit_failure_line(peaks));
    return target.quantity == "cohesion" ? strength.cohesion : strength.friction_angle;
  } catch (const InputError&) {  // peaks on a line that no friction angle has
    return none;
  }
}

}  // namespace

std::vector<Output> outputs_of(const std::vector<Target>& targets)
{
  std::vector<Output> all;
  for (std::size_t n = 0; n < targets.size(); ++n) {
    const Target& target = targets[n];
    if (target.quantity != "curve") {
      const Quantity& quantity = *find_quantity(target.quantity);
      std::string name = target.quantity;
      if (target.cases.size() == 1) name += " of " + target.cases.front();
      all.push_back({{name, target.value, target.tolerance, target.weight},
                     quantity.unit,
                     n,
                     0.0,
                     quantity.proportional});
      continue;
    }
    for (std::size_t i = 0; i < target.strain.size(); ++i)
      all.push_back(
          {{"q of " + target.cases.front() + " at " + in_words(100.0 * target.strain[i]) + " %",
            target.stress[i], target.tolerance,
            target.weight / static_cast<double>(target.strain.size())},
           "Pa",
           n,
           target.strain[i],
           true});
  }
  return all;
}

std::vector<Goal> goals_of(const std::vector<Output>& outputs)
{
  std::vector<Goal> goals;
  for (const Output& one : outputs) goals.push_back(one.goal);
  return goals;
}

double output_value(const Output& output, const Target& target,
                    const std::map<std::string, RunResult>& runs)
{
  if (target.quantity == "friction_angle" || target.quantity == "cohesion")
    return strength_value(target, runs);
  const auto run = runs.find(target.cases.front());
  if (run == runs.end() || !run->second.good()) return none;
  if (target.quantity == "curve") {
    const std::vector<double>& strain = run->second.strain;
    if (strain.size() < 2 || !got_to(strain.back(), output.strain)) return none;
    return SampledCurve(strain, run->second.stress).value(output.strain);
  }
  const auto value = run->second.values.find(target.quantity);
  return value == run->second.values.end() ? none : value->second;
}

Data RunTable::data_of(const Eigen::VectorXd& column) const
{
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < column.size(); ++row)
    if (std::isfinite(column[row])) rows.push_back(row);
  return Data{points, column, ids}.rows(rows);
}

Data RunTable::data_of(const Output& output, Eigen::Index column) const
{
  Data data = data_of(values.col(column));
  data.proportional = output.proportional && (data.values.array() > 0.0).all();
  return data;
}

Eigen::VectorXd RunTable::mean_at(int id) const
{
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(values.cols()), count = sum;
  for (std::size_t row = 0; row < ids.size(); ++row)
    for (Eigen::Index column = 0; column < values.cols(); ++column) {
      const double value = values(static_cast<Eigen::Index>(row), column);
      if (ids[row] != id || !std::isfinite(value)) continue;
      sum[column] += value;
      count[column] += 1.0;
    }
  return sum.cwiseQuotient(count);  // not a number where there is none
}

int RunTable::packings_at(int id) const
{
  int count = 0;
  for (std::size_t row = 0; row < ids.size(); ++row)
    if (ids[row] == id && values.row(static_cast<Eigen::Index>(row)).allFinite()) ++count;
  return count;
}

RunTable table_of(const CalibrationConfig& config, const std::vector<Output>& outputs,
                  const std::vector<StoredPoint>& points, const std::map<RunKey, RunResult>& runs)
{
  std::map<std::pair<int, int>, std::map<std::string, RunResult>> together;
  for (const auto& [key, result] : runs) together[{key.point, key.repeat}][key.name] = result;
  RunTable table;
  const auto rows = static_cast<Eigen::Index>(together.size());
  table.points.resize(rows, config.space.size());
  table.values.resize(rows, static_cast<Eigen::Index>(outputs.size()));
  table.seconds = Eigen::VectorXd::Constant(rows, none);
  Eigen::Index row = 0;
  for (const auto& [key, cases] : together) {
    table.ids.push_back(key.first);
    table.repeats.push_back(key.second);
    table.points.row(row) = points[static_cast<std::size_t>(key.first)].point.transpose();
    for (std::size_t n = 0; n < outputs.size(); ++n)
      table.values(row, static_cast<Eigen::Index>(n)) =
          output_value(outputs[n], config.targets[outputs[n].target], cases);
    double seconds = 0.0;
    bool whole = cases.size() == config.runs.cases.size();
    for (const auto& [name, result] : cases) {
      seconds += result.seconds;
      whole = whole && result.good();
    }
    if (whole && seconds > 0.0) table.seconds[row] = seconds;
    ++row;
  }
  return table;
}

}  // namespace encased_column
