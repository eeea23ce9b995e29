// SPDX-License-Identifier: GPL-2.0-only
#include "calibrate_command.h"

#include "core/input_error.h"
#include "report/calibration_report.h"
#include "report/parameter_file.h"
#include "runner/text_file.h"
#include "runs/run_program.h"

namespace encased_column {

namespace fs = std::filesystem;

namespace {

constexpr int stopped_by_signal = 130;

fs::path output_folder(const CalibrateOptions& options, const CalibrationConfig& config,
                       const Places& places)
{
  if (!options.out.empty()) return fs::absolute(options.out).lexically_normal();
  const fs::path root = places.source.empty() ? fs::current_path() : places.source;
  return root / "runs" / ("calibration_" + config.name);
}

std::unique_ptr<RunProgram> program_of(const CalibrationConfig& config, const Places& places,
                                       const fs::path& folder, bool slurm)
{
  switch (config.runs.kind) {
    case RunKind::encase:
      return encase_program(config, places, folder, slurm);
    case RunKind::command:
      return command_program(config, folder);
    case RunKind::formula:
      break;
  }
  return formula_program();
}

/// Forgets what is known of failed runs and what they left, so that they are made again.
void forget_failed(RunStore& store, const fs::path& folder)
{
  for (const auto& [key, result] : store.runs())
    if (!result.good()) fs::remove_all(folder / "runs" / PlannedRun{key, {}, {}}.id());
  store.forget_failed();
}

void write_results(const CalibrationConfig& config, const Calibration& calibration,
                   const Places& places, const fs::path& folder, std::ostream& out)
{
  out << "Fitting, validating and sampling: this takes a while" << std::endl;
  const Findings found = calibration.findings();
  std::string names;
  for (const ParameterFile& file : parameter_files(config, found, places.inputs / "common")) {
    write_text_file(folder / file.name, file.text);
    names += (names.empty() ? "" : " and ") + file.name;
  }
  const std::string table = parameter_text(config, found);
  write_text_file(folder / "parameters.txt", table);
  write_text_file(folder / "report.html", calibration_page(config, found, names));
  out << found.end << "\n\n" << table << '\n';
  for (const std::string& sentence : found.not_told) out << sentence << '\n';
  out << "Report:     " << shown(folder / "report.html") << "\nParameters: " << names << " in "
      << shown(folder) << ", for input_scripts/common" << std::endl;
}

}  // namespace

int calibrate(const CalibrateOptions& options, const Places& places, std::ostream& out)
{
  const CalibrationConfig config = read_calibration(options.config);
  if (options.slurm && config.runs.kind != RunKind::encase)
    throw InputError("--slurm belongs to 'program: encase', found another program in '" +
                     shown(options.config) + "', leave it out");
  const std::vector<Case> rows = rows_of_cases(config, places);
  const fs::path folder = output_folder(options, config, places);
  const fs::path file = folder / "runs.sqlite";
  const bool there = fs::exists(file);
  if (options.report && !there)
    throw InputError("--report takes a calibration that has run, found none in '" + shown(folder) +
                     "', leave --report out");
  if (there && !options.resume && !options.report)
    throw InputError("a calibration must not begin twice in one folder, found one in '" +
                     shown(folder) + "', write --resume to go on, or another --out");
  std::error_code failure;
  fs::create_directories(folder, failure);
  RunStore store(file);
  store.identify(identity_of(config, rows));
  if (options.retry) forget_failed(store, folder);
  Calibration calibration(config, rows, store, out);
  if (!options.report) {
    const auto program = program_of(config, places, folder, options.slurm);
    const RunsEnd end = calibration.run(*program);
    if (end != RunsEnd::made) {
      out << (end == RunsEnd::stopped
                  ? "Stopped: go on with --resume"
                  : "Submitted: when the jobs have ended, go on with --resume --slurm")
          << std::endl;
      return end == RunsEnd::stopped ? stopped_by_signal : 0;
    }
  }
  write_results(config, calibration, places, folder, out);
  return 0;
}

}  // namespace encased_column
