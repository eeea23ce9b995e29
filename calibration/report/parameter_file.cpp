// SPDX-License-Identifier: GPL-2.0-only
#include "report/parameter_file.h"

#include "config/units.h"
#include "core/input_error.h"

#include <cstdio>
#include <fstream>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

/// True if the files of the sleeve, of any set, declare `variable`.
bool is_of_sleeve(const std::string& variable, const fs::path& common)
{
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(common, failure)) {
    if (entry.path().filename().string().rfind("sleeve_", 0) != 0) continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);)
      if (line.rfind("variable " + variable + " ", 0) == 0) return true;
  }
  return false;
}

std::string value_line(const CalibrationConfig& config, const Findings& found, int i,
                       const std::string& variable)
{
  const Parameter& one = config.space[i];
  const StoredPoint& best = found.points[static_cast<std::size_t>(found.best)];
  const Eigen::VectorXd column = found.posterior.points.col(i);
  char value[40];
  std::snprintf(value, sizeof value, "%.6g", config.space.value(i, best.point[i]));
  return "variable " + variable + " index " + value + "  # [" + one.unit + "] 95 % interval " +
         in_words(config.space.value(i, quantile(column, 0.025))) + " to " +
         in_words(config.space.value(i, quantile(column, 0.975))) + "\n";
}

}  // namespace

std::vector<ParameterFile> parameter_files(const CalibrationConfig& config, const Findings& found,
                                           const fs::path& common)
{
  std::string base = "laboratory", grains, sleeve;
  for (const auto& [name, value] : config.runs.set)
    if (name == "parameters") base = value;
  for (int i = 0; i < config.space.size(); ++i) {
    std::vector<std::string> variables{config.space[i].name};
    variables.insert(variables.end(), config.space[i].also.begin(), config.space[i].also.end());
    for (const std::string& one : variables)
      (is_of_sleeve(one, common) ? sleeve : grains) += value_line(config, found, i, one);
  }
  std::string others;
  for (const auto& [name, value] : config.runs.set)
    if (name != "parameters") others += "#   " + name + "=" + value + "\n";
  const std::string head =
      "# The set `" + config.name + "`, calibrated with " + std::to_string(found.runs.size()) +
      " runs" + (found.met ? "; all targets are met.\n" : "; NOT all targets are met.\n") +
      (others.empty()
           ? ""
           : "# Its runs were made with these variables, which do not stand here:\n" + others);
  std::vector<ParameterFile> files{
      {"parameters_" + config.name + ".lmp",
       head + grains + "include ${common}/parameters_" + base + ".lmp\n"}};
  files.push_back({"sleeve_" + config.name + ".lmp",
                   head + sleeve + "include ${common}/sleeve_" + base + ".lmp\n"});
  return files;
}

}  // namespace encased_column
