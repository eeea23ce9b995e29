// SPDX-License-Identifier: GPL-2.0-only
#include "runner/doctor_command.h"

#include "drawing/display.h"
#include "runner/case_list.h"
#include "runner/case_shape.h"
#include "runner/doctor.h"
#include "runner/dry_run.h"
#include "runner/passing_folder.h"
#include "runner/processes.h"
#include "runner/run_command.h"
#include "runner/text_file.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iostream>
#include <sstream>
#include <thread>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

/// Runs `words` for at most `seconds`.
Trial trial_of(const std::vector<std::string>& words, double seconds)
{
  const PassingFolder folder("the check of this machine works");
  const fs::path screen = folder.path() / "screen";
  using Clock = std::chrono::steady_clock;
  const Clock::time_point began = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
  const pid_t pid = start_program({words, folder.path(), screen, true, -1, folder.path()});
  Trial trial;
  while (!has_ended(pid, trial.code)) {
    if (passed() > seconds) {
      for (const Process& process : process_tree(pid)) kill(process.pid, SIGKILL);
      while (!has_ended(pid, trial.code))
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      trial.text = "no answer in " + std::to_string(static_cast<int>(seconds)) + " s";
      return trial;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  trial.seconds = passed();
  std::ostringstream text;
  text << std::ifstream(screen).rdbuf();
  trial.text = text.str();
  return trial;
}

/// Memory and disk that the default job takes [bytes].
struct Needs {
  double memory = 0.0, disk = 0.0;
};

Needs needs_of_default_job(const Places& places, int cores)
{
  const RunOptions options;
  DeckCatalogue decks(places.inputs);
  const std::vector<CasePlan> plans = chosen_cases(read_catalogue(places, options), decks, options);
  const Schedule schedule = best_schedule(static_cast<int>(plans.size()), cores);
  Needs needs;
  double grains = 0.0;
  for (const CasePlan& plan : plans)
    if (const auto size = expected_size(plan)) {
      needs.disk += size->bytes;
      grains = std::max(grains, size->grains);
    }
  needs.memory = schedule.jobs * schedule.ranks * memory_of_case(grains);
  return needs;
}

}  // namespace

int doctor_command(const Places& places)
{
  constexpr double patience = 30.0;  // seconds for a program to answer
  constexpr int ranks = 2;
  const int cores = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
  const Needs needs = needs_of_default_job(places, cores);
  const fs::path folder = output_folder(places, {});
  fs::path there = folder;
  while (!fs::exists(there) && there.has_relative_path()) there = there.parent_path();
  std::ostringstream memory;
  memory << std::ifstream("/proc/meminfo").rdbuf();

  std::vector<Finding> findings;
  findings.push_back(
      judge_programs(trial_of({places.host, "-version"}, patience), places.host.string()));
  if (findings.front().verdict == Finding::Verdict::good) {
    set_up_open_mpi(ranks > cores);
    const PassingFolder input("the check of this machine works");
    write_text_file(input.path() / "in.lmp", "print done\n");
    findings.push_back(
        judge_mpi(trial_of({"mpirun", "-np", std::to_string(ranks), "--oversubscribe", "--bind-to",
                            "none", places.host, "-in", input.path() / "in.lmp", "-log", "none"},
                           patience),
                  ranks));
  }
  findings.push_back(judge_display(display_problem()));
  findings.push_back(judge_disk(free_bytes_of(folder), needs.disk, shown(folder),
                                access(there.c_str(), W_OK | X_OK) == 0));
  findings.push_back(judge_memory(available_memory(memory.str()), needs.memory));
  findings.push_back(judge_cores(cores));
  findings.push_back(judge_slurm(trial_of({"scontrol", "ping"}, patience)));
  std::cout << doctor_text(findings);
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& one) { return one.verdict == Finding::Verdict::bad; });
}

}  // namespace encased_column
