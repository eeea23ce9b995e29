// SPDX-License-Identifier: GPL-2.0-only
// The program `encase-calibrate`, behind the command `encase calibrate`: apart, so that `encase`
// needs none of its libraries.
#include "calibrate_command.h"

#include <CLI/CLI.hpp>

#include <iostream>

using namespace encased_column;

int main(int count, char** words)
{
  CLI::App app{
      "Finds parameters of the decks with which tests give what the laboratory found, and how "
      "sure they are: calibration/README.md",
      "encase calibrate"};
  CalibrateOptions options;
  app.add_option("config", options.config, "YAML file that says what is looked for")
      ->required()
      ->type_name("CONFIG");
  app.add_option("--out", options.out, "results go to this folder (default: runs/calibration_NAME)")
      ->type_name("DIR");
  app.add_flag("--resume", options.resume, "go on with a calibration that was stopped or killed");
  app.add_flag("--report", options.report, "report on what has run, and run nothing");
  app.add_flag("--retry", options.retry, "with --resume: make runs again that failed");
  app.add_flag("--slurm", options.slurm, "submit runs to Slurm and end; go on with --resume");
  try {
    app.parse(count, words);
  } catch (const CLI::Success& wish) {
    return app.exit(wish);
  } catch (const CLI::ParseError& problem) {
    std::cerr << "encase calibrate: " << problem.what() << ", see --help\n";
    return 1;
  }
  try {
    return calibrate(options, find_places(), std::cout);
  } catch (const std::exception& problem) {
    std::cerr << "encase calibrate: " << problem.what() << '\n';
    return 1;
  }
}
