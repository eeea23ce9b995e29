// SPDX-License-Identifier: GPL-2.0-only
#include "config/calibration_config.h"

#include "config/curve_file.h"
#include "config/quantities.h"
#include "config/units.h"
#include "core/input_error.h"

#include <algorithm>
#include <set>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

Parameter read_parameter(const YamlMap& map)
{
  Parameter one;
  one.name = map.text("name");
  read_setting(map.place("name"), one.name + "=1");  // a name the decks can have
  if (map.has("also")) one.also = map.texts("also");
  for (const std::string& other : one.also) read_setting(map.place("also"), other + "=1");
  one.unit = map.text("unit", "-");
  one.low = map.number_in("low", one.unit);
  one.high = map.number_in("high", one.unit);
  one.logarithmic = map.choice("scale", {"linear", "log"}, "linear") == "log";
  if (!(one.low < one.high))
    throw InputError(map.place("high") + " must be larger than 'low', found '" + map.text("high") +
                     "' and '" + map.text("low") + "', write the larger one there");
  if (one.logarithmic && !(one.low > 0.0))
    throw InputError(map.place("low") + " must be above 0 with 'scale: log', found '" +
                     map.text("low") + "', write a small number or 'scale: linear'");
  return one;
}

ParameterSpace read_parameters(const YamlMap& top)
{
  std::vector<Parameter> all;
  for (const YamlMap& map : top.maps("parameters", "a parameter", config_keys().parameter)) {
    Parameter one = read_parameter(map);
    for (const Parameter& other : all)
      if (other.name == one.name)
        throw InputError(map.place("name") + " must be another one for each parameter, found '" +
                         one.name + "' twice, leave one out");
    all.push_back(std::move(one));
  }
  return ParameterSpace(all);
}

std::vector<Eigen::VectorXd> read_known(const YamlMap& top, const ParameterSpace& space)
{
  std::vector<Eigen::VectorXd> points;
  if (!top.has("known")) return points;
  std::vector<ConfigKey> keys;
  for (const Parameter& one : space.parameters()) keys.push_back({one.name, ""});
  for (const YamlMap& map : top.maps("known", "a known point", keys)) {
    Eigen::VectorXd point(space.size());
    for (int i = 0; i < space.size(); ++i) {
      const double value = map.number_in(space[i].name, space[i].unit);
      if (value < space[i].low || value > space[i].high)
        throw InputError(map.place(space[i].name) + " must be within the range of its parameter, " +
                         in_words(space[i].low) + " to " + in_words(space[i].high) + ", found '" +
                         map.text(space[i].name) + "', widen the range or leave the point out");
      point[i] = space.share(i, value);
    }
    points.push_back(point);
  }
  return points;
}

RunPlan read_runs(const YamlMap& top, const fs::path& folder)
{
  const YamlMap map = top.map("runs", config_keys().runs);
  RunPlan plan;
  const std::vector<std::string> program =
      map.has("program") ? map.texts("program") : std::vector<std::string>{"encase"};
  if (program == std::vector<std::string>{"formula"})
    plan.kind = RunKind::formula;
  else if (program != std::vector<std::string>{"encase"}) {
    plan.kind = RunKind::command;
    plan.command = program;
    if (plan.command.front().find('/') != std::string::npos)
      plan.command.front() = fs::absolute(folder / plan.command.front()).lexically_normal();
  }
  if (map.has("cases_file")) plan.cases_file = folder / map.text("cases_file");
  plan.cases = map.texts("cases");
  const std::set<std::string> different(plan.cases.begin(), plan.cases.end());
  if (different.size() < plan.cases.size())
    throw InputError(map.place("cases") + " must name a case once, found one twice, leave it out");
  for (const auto& [name, value] : map.pairs("set"))
    plan.set.push_back(read_setting(map.place("set"), name + "=" + value));
  plan.resolution = map.text("resolution", "");
  plan.ranks = map.has("ranks") ? std::to_string(map.integer("ranks", 1, 999, 1)) : "";
  plan.jobs = map.has("jobs") ? std::to_string(map.integer("jobs", 1, 999, 2)) : "";
  if (map.has("slurm_options")) plan.slurm_options = map.texts("slurm_options");
  plan.keep_files = map.yes("keep_files", false);
  return plan;
}

/// "5 %" of `value`, or a number in its unit.
double read_tolerance(const YamlMap& map, double value, const std::string& unit)
{
  const std::string word = map.text("tolerance");
  const bool share = !word.empty() && word.back() == '%' && unit != "-";
  const double tolerance = share ? std::abs(value) * read_in_unit(map.place("tolerance"), word, "-")
                                 : map.number_in("tolerance", unit);
  if (!(tolerance > 0.0))
    throw InputError(map.place("tolerance") + " must be above 0, found '" + word +
                     "', write for example '5 %' of the value");
  return tolerance;
}

void read_curve(const YamlMap& map, const fs::path& folder, Target& target)
{
  target.quantity = "curve";
  const SampledCurve curve = read_curve_file(folder / map.text("curve"), map.place("curve"));
  const auto count = static_cast<std::size_t>(map.integer("strains", 2, 100, 8));
  target.whole_strain = curve.x();
  target.whole_stress = curve.y();
  const double last = curve.x().back();
  for (std::size_t n = 1; n <= count; ++n) {
    target.strain.push_back(last * static_cast<double>(n) / static_cast<double>(count));
    target.stress.push_back(curve.value(target.strain.back()));
  }
  target.value = *std::max_element(target.stress.begin(), target.stress.end());
}

Target read_target(const YamlMap& map, const RunPlan& runs, const fs::path& folder)
{
  Target target;
  std::string unit = "Pa";
  const Quantity* quantity = nullptr;
  if (map.has("curve") == map.has("quantity"))
    throw InputError("a target " + map.where() +
                     " takes 'quantity' with 'value', or 'curve', found " +
                     (map.has("curve") ? "both" : "neither") + ", write one of them");
  if (map.has("curve"))
    read_curve(map, folder, target);
  else {
    target.quantity = map.text("quantity");
    std::vector<std::string> names;
    for (const Quantity& one : quantities()) names.push_back(one.name);
    map.choice("quantity", names, "");
    quantity = find_quantity(target.quantity);
    unit = quantity->unit;
    target.value = map.number_in("value", unit);
  }
  const bool several = quantity && quantity->of_several;
  const std::string key = several ? "cases" : "case";
  target.cases = several && !map.has(key) ? runs.cases : map.texts(key);
  for (const std::string& name : target.cases)
    if (std::find(runs.cases.begin(), runs.cases.end(), name) == runs.cases.end())
      throw InputError(map.place(key) + " must be one of 'cases' of 'runs', found '" + name +
                       "', expected one of: " + joined(runs.cases));
  if (several ? target.cases.size() < 2 : target.cases.size() != 1)
    throw InputError(map.place(key) + " takes " + (several ? "two cases at least" : "one case") +
                     " for '" + target.quantity + "', found " +
                     std::to_string(target.cases.size()) + ", write for example '" + key + ": " +
                     (several ? "[plain_050, plain_150]'" : "plain_050'"));
  target.tolerance = read_tolerance(map, target.value, unit);
  if (map.has("weight")) target.weight = map.number_in("weight", "-");
  if (target.weight < 0.0)
    throw InputError(map.place("weight") + " must not be negative, found '" + map.text("weight") +
                     "', write 0 for a value that is foretold and not fitted");
  return target;
}

std::vector<SurrogateKind> read_surrogates(const YamlMap& map)
{
  const std::vector<std::string> names{"regression", "network", "kriging"};
  std::vector<SurrogateKind> kinds;
  for (const std::string& word : map.texts("surrogates")) {
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end())
      throw InputError(map.place("surrogates") + " takes regression, network and kriging, found '" +
                       word + "', write for example '[regression, network]'");
    kinds.push_back(static_cast<SurrogateKind>(found - names.begin()));
  }
  return kinds;
}

DesignPlan read_design(const YamlMap& top)
{
  const YamlMap map = top.map("design", config_keys().design);
  DesignPlan plan;
  if (map.choice("kind", {"sobol", "latin_hypercube"}, "sobol") == "latin_hypercube")
    plan.kind = DesignKind::latin_hypercube;
  plan.points = static_cast<int>(map.integer("points", 10, 100'000, plan.points));
  plan.morris_ways = static_cast<int>(map.integer("morris_ways", 0, 1000, plan.morris_ways));
  plan.repeated = static_cast<int>(map.integer("repeated", 0, plan.points, plan.repeated));
  plan.repeats = static_cast<int>(map.integer("repeats", 1, 100, plan.repeats));
  plan.seed = static_cast<unsigned>(map.integer("seed", 1, 1'000'000, plan.seed));
  return plan;
}

SearchPlan read_search(const YamlMap& top)
{
  const YamlMap map = top.map("search", config_keys().search);
  SearchPlan plan;
  if (map.has("surrogates")) plan.surrogates = read_surrogates(map);
  plan.folds = static_cast<int>(map.integer("folds", 2, 100, plan.folds));
  plan.rounds = static_cast<int>(map.integer("rounds", 0, 100, plan.rounds));
  plan.candidates = static_cast<int>(map.integer("candidates", 1, 100, plan.candidates));
  plan.cost = map.yes("cost", plan.cost);
  plan.samples = static_cast<int>(map.integer("samples", 400, 1'000'000, plan.samples));
  return plan;
}

}  // namespace

CalibrationConfig read_calibration(const fs::path& file)
{
  const YamlMap top = read_yaml(file, config_keys().top);
  const fs::path folder = file.parent_path();
  CalibrationConfig config;
  config.file = file;
  config.name = top.text("name");
  if (!is_folder_name(config.name))
    throw InputError(top.place("name") + " takes letters, digits, '_', '-' and '.', found '" +
                     config.name + "', write for example 'name: gravel'");
  config.title = top.text("title", config.name);
  config.runs = read_runs(top, folder);
  config.space = read_parameters(top);
  config.known = read_known(top, config.space);
  for (const YamlMap& map : top.maps("targets", "a target", config_keys().target))
    config.targets.push_back(read_target(map, config.runs, folder));
  if (std::none_of(config.targets.begin(), config.targets.end(),
                   [](const Target& one) { return one.weight > 0.0; }))
    throw InputError(top.place("targets") +
                     " must have one with a weight above 0, found none, leave a 'weight: 0' out");
  config.design = read_design(top);
  config.search = read_search(top);
  config.budget = top.integer("budget", 1, 10'000'000, config.budget);
  return config;
}

}  // namespace encased_column
