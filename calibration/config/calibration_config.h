// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "config/yaml_map.h"
#include "runner/case_record.h"
#include "space/designs.h"
#include "space/parameter_space.h"
#include "surrogate/surrogate.h"

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column {

/// What makes a run.
enum class RunKind {
  encase,   ///< decks of this project, by `encase run`
  command,  ///< a program of the user's
  formula   ///< a closed form in place of a test, to try things out
};

struct RunPlan {
  RunKind kind = RunKind::encase;
  std::vector<std::string> command;     ///< words of the user's program
  std::filesystem::path cases_file;     ///< empty: our own series.csv
  std::vector<std::string> cases;       ///< their ids
  Settings set;                         ///< variables of all cases
  std::string resolution, ranks, jobs;  ///< empty: what `encase run` takes
  std::vector<std::string> slurm_options;
  bool keep_files = false;  ///< pictures and grains of every run
};

/// A value, or a curve, of the laboratory.
struct Target {
  std::string quantity;                               ///< "curve" for a whole one
  std::vector<std::string> cases;                     ///< one, or several for a failure line
  double value = 0.0, tolerance = 0.0, weight = 1.0;  ///< SI
  std::vector<double> strain, stress;              ///< of a curve: where it is compared [-], [Pa]
  std::vector<double> whole_strain, whole_stress;  ///< of a curve: as the file has it
};

struct DesignPlan {
  DesignKind kind = DesignKind::sobol;
  int points = 60;
  int morris_ways = 0;  ///< runs of their own for the sensitivity
  int repeated = 2;     ///< points of the design that are run with several packings
  int repeats = 3;      ///< packings of these, and of the best candidates
  unsigned seed = 1;
};

struct SearchPlan {
  std::vector<SurrogateKind> surrogates{SurrogateKind::polynomial, SurrogateKind::network,
                                        SurrogateKind::kriging};
  int folds = 10;
  int rounds = 4;
  int candidates = 4;  ///< of each round
  bool cost = false;   ///< the time of a run is a second objective
  int samples = 8000;  ///< of the posterior
};

/// All that a user asks of a calibration.
struct CalibrationConfig {
  std::string name, title;
  std::filesystem::path file;
  ParameterSpace space;
  std::vector<Eigen::VectorXd> known;  ///< points of the unit cube that the user wants run
  RunPlan runs;
  std::vector<Target> targets;
  DesignPlan design;
  SearchPlan search;
  long budget = 1000;  ///< runs of cases in all
};

/// The keys of each part of the file, as the user page lists them.
struct ConfigKeys {
  std::vector<ConfigKey> top, runs, parameter, target, design, search;
};
const ConfigKeys& config_keys();

/// Reads `file`; paths in it are from its folder. Throws InputError with file and line.
CalibrationConfig read_calibration(const std::filesystem::path& file);

}  // namespace encased_column
