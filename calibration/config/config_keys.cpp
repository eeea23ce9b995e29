// SPDX-License-Identifier: GPL-2.0-only
#include "config/calibration_config.h"

namespace encased_column {

const ConfigKeys& config_keys()
{
  static const ConfigKeys keys{
      {{"name", "of the run folder and the set of parameters: letters, digits, '_', '-', '.'"},
       {"title", "of the report"},
       {"runs", "what is run"},
       {"parameters", "what is looked for: a list"},
       {"targets", "what is to be met: a list"},
       {"known",
        "points of your own, run with several packings: a list, a value of each parameter"},
       {"design", "the first points"},
       {"search", "surrogates, search and posterior"},
       {"budget", "runs of cases in all, at most"}},
      {{"program", "encase (default), a program of your own with its words, or formula"},
       {"cases_file", "CSV file of the cases (default: our own series.csv)"},
       {"cases", "ids of its rows"},
       {"set", "variables of all cases, NAME: VALUE"},
       {"resolution", "quick, standard or paper"},
       {"ranks", "MPI ranks of a case"},
       {"jobs", "cases at once"},
       {"slurm_options", "options of sbatch, for --slurm"},
       {"keep_files", "yes: pictures, grains and restart files of every run stay (default: no)"}},
      {{"name", "of the deck's variable"},
       {"low", "lower end of its range"},
       {"high", "upper end"},
       {"scale", "linear (default) or log"},
       {"unit", "its SI unit (default: none)"},
       {"also", "other variables that take the same value"}},
      {{"quantity", "what is compared, from the table below"},
       {"curve", "in its place: CSV file of a whole curve"},
       {"strains", "at how many strains a curve is compared (default: 8)"},
       {"case", "of which test"},
       {"cases", "of which tests, for friction_angle and cohesion (default: all)"},
       {"value", "of the laboratory, with unit"},
       {"tolerance", "in the same unit or in percent of the value: within it a value is met"},
       {"weight", "default 1; 0: foretold and compared, not fitted"}},
      {{"kind", "sobol (default) or latin_hypercube"},
       {"points", "that fill the ranges evenly (default: 60)"},
       {"morris_ways", "of Morris's method, each of one run more than parameters (default: 0)"},
       {"repeated", "points run with several packings (default: 2)"},
       {"repeats", "packings of these and of the best candidates (default: 3)"},
       {"seed", "of all random numbers, packings too (default: 1)"}},
      {{"surrogates", "of regression, network, kriging (default: all three)"},
       {"folds", "of the cross-validation (default: 10)"},
       {"rounds", "of candidates, at most (default: 4)"},
       {"candidates", "of a round (default: 4)"},
       {"cost", "yes: the time of a run is a second objective (default: no)"},
       {"samples", "of the posterior (default: 8000)"}}};
  return keys;
}

}  // namespace encased_column
