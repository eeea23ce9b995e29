// SPDX-License-Identifier: GPL-2.0-only
#include "runner/run_command.h"

#include "core/input_error.h"
#include "runner/announcement.h"
#include "runner/case_list.h"
#include "runner/case_shape.h"
#include "runner/decided_cases.h"
#include "runner/dry_run.h"
#include "runner/machine_speed.h"
#include "runner/processes.h"
#include "runner/progress.h"
#include "runner/run_cases.h"
#include "runner/series_end.h"
#include "runner/slurm_submit.h"
#include "runner/text_file.h"
#include "runner/version.h"

#include <unistd.h>

#include <csignal>
#include <iostream>
#include <thread>

namespace encased_column {

namespace fs = std::filesystem;

fs::path output_folder(const Places& places, const RunOptions& options)
{
  if (!options.out.empty()) return fs::absolute(options.out).lexically_normal();
  const fs::path root = places.source.empty() ? fs::current_path() : places.source;
  const std::string usual = options.is_series() ? options.series : "default";
  return root / "runs" / (options.name.empty() ? usual : options.name);
}

namespace {

std::string version_of_project(const Places& places)
{
  std::string version;
  if (!places.source.empty())
    version = output_of({"git", "-C", places.source, "describe", "--always", "--dirty", "--tags"});
  while (!version.empty() && version.back() == '\n') version.pop_back();
  return version.empty() ? project_version() : version;
}

}  // namespace

void set_up_open_mpi(bool crowded)
{
  if (geteuid() == 0) {  // which Open MPI refuses unless told twice
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 0);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 0);
  }
  // Seconds that mpirun leaves its ranks between SIGTERM and SIGKILL: enough for a restart file. It
  // waits them out, twice, behind a rank that ended with an error too.
  setenv("OMPI_MCA_odls_base_sigkill_timeout", "5", 0);
  if (crowded) setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
}

namespace {

std::vector<std::string> ids_of(const std::vector<Todo>& todo)
{
  std::vector<std::string> ids;
  for (const Todo& one : todo) ids.push_back(one.folder.id());
  return ids;
}

std::string resolution_of(const Todo& todo)
{
  for (const auto& [name, value] : todo.folder.plan().asked)
    if (name == "resolution") return " at " + value + " resolution";
  return "";
}

/// `todo` as a dry run would list it.
std::vector<ExpectedCase> expected(const std::vector<Todo>& todo)
{
  std::vector<ExpectedCase> cases;
  for (const Todo& one : todo) {
    ExpectedCase expected{one.folder.id(), std::nullopt, 0.0, ""};
    try {
      expected.size = expected_size(one.folder.plan());
    } catch (const InputError&) {
      // The case itself will refuse what is wrong there, and says where.
    }
    if (one.decision.action == Action::resume) expected.done = one.folder.progress().fraction;
    cases.push_back(std::move(expected));
  }
  return cases;
}

/// Says what is about to run and how long it takes here.
void announce(const std::vector<Todo>& todo, const Places& places, const Schedule& schedule,
              const RunOptions& options, const fs::path& series)
{
  const std::vector<ExpectedCase> cases = expected(todo);
  std::optional<double> rate;
  if (takes_minutes(cases, schedule)) try {
      rate = measure_machine(places, schedule.ranks * std::min<int>(schedule.jobs, cases.size()));
    } catch (const InputError&) {
      // Where no file can be made for it, cases may run all the same.
    }
  std::cout << announcement(cases, schedule, rate,
                            {shown(series), free_bytes_of(series), !options.no_pictures})
            << std::flush;
}

/// The ids of cases, or how many where a line would not hold them.
std::string named_or_counted(const std::vector<std::string>& ids)
{
  constexpr std::size_t in_a_line = 12;
  if (ids.size() <= in_a_line) return joined(ids);
  return std::to_string(ids.size()) + " cases, " + ids.front() + " to " + ids.back();
}

/// Runs them; returns the ids of those that failed.
std::vector<std::string> run_all(std::vector<Todo>& todo, const Places& places,
                                 const RunOptions& options, const fs::path& series, int cores,
                                 StopSignals& signals)
{
  const Schedule schedule = best_schedule(static_cast<int>(todo.size()), cores,
                                          options.rank_count(), options.job_count());
  if (!options.no_report) announce(todo, places, schedule, options, series);
  std::cout << "Running " << named_or_counted(ids_of(todo)) << resolution_of(todo.front())
            << "; at once: " << schedule.jobs << ", MPI ranks each: " << schedule.ranks
            << std::endl;
  set_up_open_mpi(schedule.ranks * schedule.jobs > cores);
  CaseRunner runner(places, schedule,
                    versions_text(version_of_project(places), cores, schedule.ranks,
                                  places.inputs / "packages.txt"),
                    signals);
  return runner.run(todo);
}

/// What a signal has left of `todo`.
Left left_of(const std::vector<Todo>& todo, bool series)
{
  Left left;
  left.series = series;
  for (const Todo& one : todo) {
    if (one.folder.state().finished) continue;
    const int stage = one.folder.last_stage();
    if (stage)
      left.resumable.emplace_back(one.folder.id(), stage);
    else
      left.begin_again.push_back(one.folder.id());
  }
  left.tables_missing = true;
  return left;
}

}  // namespace

int run_command(const Places& places, const RunOptions& options)
{
  options.check();
  const Catalogue catalogue = read_catalogue(places, options);
  DeckCatalogue decks(places.inputs);
  const std::vector<CasePlan> plans = chosen_cases(catalogue, decks, options);
  if (!fs::exists(places.host))
    throw InputError("the program must find 'liggghts-encase' beside itself, found none in '" +
                     places.host.parent_path().string() + "', build or install both");

  const fs::path series = output_folder(places, options);
  const int cores = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
  if (options.dry_run) return dry_run(places, plans, options, series, cores);
  StopSignals signals;
  make_folder(series);
  FolderLock series_lock;
  if (!options.no_report && !series_lock.take(series / ".lock", 0.5))
    throw InputError("'" + shown(series) + "' is in use by another run, choose another --name");
  auto [todo, failed] =
      options.report_only ? Decided{} : decide_all(plans, series, places, options);
  if (options.slurm) return submit_to_slurm(places, options, series, ids_of(todo), plans);
  if (!todo.empty())
    for (const std::string& id : run_all(todo, places, options, series, cores, signals))
      failed.push_back(id);
  const bool reports = !options.no_report && failed.size() < plans.size();
  if (!signals.count() && reports && !make_report(places, options, series, signals) &&
      !signals.count())
    failed.push_back("report");
  if (signals.count()) {
    std::cout << stopped_line(left_of(todo, options.is_series())) << std::endl;
    return 128 + signals.first();
  }
  std::cout << std::endl;
  bool all_ran = true;
  if (options.is_series() || options.report_only) all_ran = tell_outcomes(plans, series);
  if (!failed.empty()) std::cerr << "Failed: " << joined(failed) << std::endl;
  if (!options.no_report) tell_results(series, options);
  return failed.empty() && all_ran ? 0 : 1;
}

int list_command(const Places& places, const RunOptions& options)
{
  DeckCatalogue decks(places.inputs);
  list_cases(std::cout, read_catalogue(places, options), decks, options);
  return 0;
}

}  // namespace encased_column
