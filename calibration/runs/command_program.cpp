// SPDX-License-Identifier: GPL-2.0-only
#include "config/curve_file.h"
#include "core/input_error.h"
#include "runner/processes.h"
#include "runner/stop_signals.h"
#include "runner/text_file.h"
#include "runs/run_program.h"
#include "runs/signal_mask.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

struct Running {
  const PlannedRun* run;
  pid_t pid;
  Clock::time_point began;
};

RunResult read_folder(const fs::path& folder, const PlannedRun& run)
{
  const SampledCurve curve =
      read_curve_file(folder / "curve.csv", "a run, '" + shown(folder / "curve.csv") + "'");
  RunResult result = result_of_curve(curve.x(), curve.y(), run.number("sigma3", 100e3));
  thin_curve(result);
  const fs::path values = folder / "values.csv";
  if (!fs::exists(values)) return result;
  for (const auto& row : csv_rows(read_text_file(values, shown(values)), shown(values)))
    if (row.size() >= 2 && row[0] != "quantity")
      result.values[row[0]] = read_number("'" + row[0] + "' in '" + shown(values) + "'", row[1]);
  return result;
}

class CommandProgram : public RunProgram {
 public:
  CommandProgram(const CalibrationConfig& config, const fs::path& folder)
      : plan_(config.runs),
        folder_(folder)
  {
  }

  RunsEnd make(const std::vector<PlannedRun>& runs, const Tell& tell) override
  {
    const std::size_t jobs = plan_.jobs.empty() ? 1 : std::stoul(plan_.jobs);
    const SignalMask mask;
    StopSignals signals;
    std::vector<Running> running;
    std::size_t next = 0;
    while (!running.empty() || (next < runs.size() && !signals.count())) {
      while (running.size() < jobs && next < runs.size() && !signals.count())
        running.push_back(start(runs[next++]));
      if (signals.wait(0.02))
        for (const Running& one : running) kill(one.pid, SIGTERM);
      for (Running& one : running) {
        int code = 0;
        if (!has_ended(one.pid, code)) continue;
        if (!signals.count()) tell(*one.run, result_of(one, code));
        one.run = nullptr;
      }
      running.erase(std::remove_if(running.begin(), running.end(),
                                   [](const Running& one) { return !one.run; }),
                    running.end());
    }
    return signals.count() ? RunsEnd::stopped : RunsEnd::made;
  }

 private:
  Running start(const PlannedRun& run) const
  {
    const fs::path folder = folder_ / run.id();
    fs::remove_all(folder);
    fs::create_directories(folder);
    Start start;
    start.words = plan_.command;
    for (const auto& [name, value] : run.variables) start.words.push_back(name + "=" + value);
    start.folder = folder;
    start.screen = folder / "output.txt";
    start.own_session = true;
    return {&run, start_program(start), Clock::now()};
  }

  RunResult result_of(const Running& one, int code) const
  {
    RunResult result;
    try {
      if (code != 0)
        result.problem =
            "exit code " + std::to_string(code) + " of '" + plan_.command.front() + "'";
      else
        result = read_folder(folder_ / one.run->id(), *one.run);
    } catch (const InputError& problem) {
      result.problem = problem.what();
    }
    result.seconds = std::chrono::duration<double>(Clock::now() - one.began).count();
    return result;
  }

  RunPlan plan_;
  fs::path folder_;
};

}  // namespace

std::unique_ptr<RunProgram> command_program(const CalibrationConfig& config, const fs::path& folder)
{
  return std::make_unique<CommandProgram>(config, folder / "runs");
}

}  // namespace encased_column
