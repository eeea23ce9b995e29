// SPDX-License-Identifier: GPL-2.0-only
#include "core/input_error.h"
#include "files/column_names.h"
#include "reading/run_record.h"
#include "runner/processes.h"
#include "runner/stop_signals.h"
#include "runner/text_file.h"
#include "runs/run_program.h"
#include "runs/signal_mask.h"
#include "tables/evaluation.h"

#include <csignal>
#include <fstream>
#include <set>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

constexpr double look_every = 1.0;  // s

std::string cases_text(const std::vector<PlannedRun>& runs)
{
  std::string text = "id,series,deck,variables,title\n";
  for (const PlannedRun& run : runs) {
    std::string variables;
    for (const auto& [name, value] : run.variables)
      variables += (variables.empty() ? "" : ";") + name + "=" + value;
    for (const std::string& cell : {run.id(), std::string("calibration"), run.row.deck, variables})
      text += csv_cell(cell) + ",";
    text += csv_cell(run.row.title) + "\n";
  }
  return text;
}

std::string first_line(const fs::path& file)
{
  std::string line;
  std::ifstream stream(file);
  std::getline(stream, line);
  return line;
}

/// What the finished case in `folder` gave.
RunResult read_case(const fs::path& folder, const Targets& targets)
{
  const CaseRuns found = read_case_runs({folder});
  const CaseRun& run = found.runs.front();
  const std::vector<SetResult> sets = evaluate(found.runs, {}, targets);
  const TestResult& test = sets.front().tests.front();
  const std::optional<double> asked = run.number("strain_end");
  const std::vector<double>& strain = test.axial_strain;
  const double rest = strain.size() < 2 ? 0.0 : 1.1 * (strain.back() - *(strain.end() - 2));
  if (asked && strain.back() + rest < *asked)  // the rest: a step between samples
    throw InputError("shear must go to an axial strain of " + in_words(*asked) +
                     ", found its end at " + in_words(test.axial_strain.back()) +
                     ", see log.liggghts");
  RunResult result =
      result_of_curve(test.axial_strain, test.deviatoric_stress, run.confining_stress);
  result.values["peak_p"] = test.peak_stress.mean_stress;
  result.values["end_volumetric_strain"] = test.volumetric_strain.back();
  result.values["porosity"] = run.history.numbers(history_column::porosity_less_overlap).front();
  if (run.encased()) {
    const std::pair<const char*, ColumnName> heights[] = {
        {"radial_strain_25", history_column::radial_strain_25},
        {"radial_strain_50", history_column::radial_strain_50},
        {"radial_strain_75", history_column::radial_strain_75}};
    // Histories count the radius getting shorter as positive, the study its expansion.
    for (const auto& [name, column] : heights)
      result.values[name] = -run.history.numbers(column).back();
  }
  thin_curve(result);
  return result;
}

/// Of what a run leaves, all that is large and not needed to repeat it.
void remove_large_files(const fs::path& folder)
{
  std::vector<fs::path> large;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    const bool pictures = entry.is_directory() && name != "input";
    if (pictures || name.rfind("restart_", 0) == 0) large.push_back(entry.path());
  }
  for (const fs::path& one : large) fs::remove_all(one);
}

class EncaseProgram : public RunProgram {
 public:
  EncaseProgram(const CalibrationConfig& config, const Places& places, const fs::path& folder,
                bool slurm)
      : plan_(config.runs),
        program_(places.program.parent_path() / "encase"),
        folder_(folder),
        targets_(places.source.empty() ? places.inputs / "targets.csv"
                                       : places.source / "postprocess" / "targets.csv"),
        slurm_(slurm)
  {
  }

  RunsEnd make(const std::vector<PlannedRun>& runs, const Tell& tell) override
  {
    std::set<std::string> told;
    collect(runs, tell, told);
    if (told.size() == runs.size()) return RunsEnd::made;
    fs::create_directories(folder_);
    const fs::path cases = folder_ / "cases.csv";
    write_text_file(cases, cases_text(runs));
    const SignalMask mask;
    StopSignals signals;
    Start start;
    start.words = words(cases);
    start.own_session = true;
    const pid_t pid = start_program(start);
    int code = 0;
    while (!has_ended(pid, code)) {
      if (signals.wait(look_every)) kill(pid, SIGTERM);
      collect(runs, tell, told);
    }
    collect(runs, tell, told);
    if (signals.count()) return RunsEnd::stopped;
    if (told.size() == runs.size()) return RunsEnd::made;
    if (slurm_ && code == 0) return RunsEnd::submitted;
    throw InputError("'encase run' must make all runs, found it ended with exit code " +
                     std::to_string(code) + " and " + std::to_string(runs.size() - told.size()) +
                     " of them missing, see what it says above");
  }

 private:
  std::vector<std::string> words(const fs::path& cases) const
  {
    std::vector<std::string> all{program_, "run",   "--cases", cases,        "--series",
                                 "all",    "--out", folder_,   "--no-report"};
    const auto add = [&](const char* option, const std::string& value) {
      if (!value.empty()) all.insert(all.end(), {option, value});
    };
    add("--resolution", plan_.resolution);
    add("--ranks", plan_.ranks);
    add("--jobs", plan_.jobs);
    if (!slurm_) return all;
    all.emplace_back("--slurm");
    for (const std::string& option : plan_.slurm_options) add("--slurm-option", option);
    return all;
  }

  /// Tells the runs that have ended since the last call.
  void collect(const std::vector<PlannedRun>& runs, const Tell& tell, std::set<std::string>& told)
  {
    for (const PlannedRun& run : runs) {
      const fs::path folder = folder_ / run.id();
      const bool finished = fs::exists(folder / "finished");
      if (told.count(run.id()) || (!finished && !fs::exists(folder / "failed"))) continue;
      RunResult result;
      if (finished) try {
          result = read_case(folder, targets_);
        } catch (const InputError& problem) {
          result.problem = problem.what();
        }
      else
        result.problem = first_line(folder / "failed");
      if (const auto record = read_run_record(folder); record.wall_time)
        result.seconds = static_cast<double>(*record.wall_time);
      tell(run, result);
      told.insert(run.id());
      if (finished && !plan_.keep_files) remove_large_files(folder);
    }
  }

  RunPlan plan_;
  fs::path program_, folder_;
  Targets targets_;
  bool slurm_;
};

}  // namespace

std::unique_ptr<RunProgram> encase_program(const CalibrationConfig& config, const Places& places,
                                           const fs::path& folder, bool slurm)
{
  return std::make_unique<EncaseProgram>(config, places, folder / "runs", slurm);
}

}  // namespace encased_column
