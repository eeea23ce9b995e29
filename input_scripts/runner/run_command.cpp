#include "runner/run_command.h"

#include "core/input_error.h"
#include "runner/case_list.h"
#include "runner/case_variables.h"
#include "runner/processes.h"
#include "runner/progress.h"
#include "runner/run_cases.h"
#include "runner/text_file.h"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

fs::path output_folder(const Places& places, const RunOptions& options)
{
  if (!options.out.empty()) return fs::absolute(options.out).lexically_normal();
  const fs::path root = places.source.empty() ? fs::current_path() : places.source;
  return root / "runs" / (options.name.empty() ? "default" : options.name);
}

void make_folder(const fs::path& folder)
{
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure || access(folder.c_str(), W_OK | X_OK) != 0)
    throw InputError("cannot write the output folder '" + shown(folder) +
                     "', free it or choose another --name or --out");
}

/// The lock of the case's folder, in which nothing else may run; a process that is about to end
/// gets `seconds` for it.
FolderLock lock_of(const CaseFolder& folder, const Places& places, double seconds)
{
  FolderLock lock;
  const bool free = lock.take(folder.path() / ".lock", seconds);
  pid_t pid = process_in(folder.path(), places.host);
  for (double waited = 0.0; free && pid && waited < seconds; waited += 0.1) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    pid = process_in(folder.path(), places.host);
  }
  if (free && !pid) return lock;
  throw InputError("case '" + folder.id() + "' must not run twice in '" + shown(folder.path()) +
                   "', found it still running" + (pid ? " as process " + std::to_string(pid) : "") +
                   ", wait for its end" +
                   (pid ? " or write 'kill " + std::to_string(pid) + "'" : ""));
}

std::string version_of_project(const Places& places)
{
  std::string version;
  if (!places.source.empty())
    version = output_of({"git", "-C", places.source, "describe", "--always", "--dirty", "--tags"});
  while (!version.empty() && version.back() == '\n') version.pop_back();
  return version.empty() ? ENCASE_VERSION : version;
}

void set_up_open_mpi(bool crowded)
{
  if (geteuid() == 0) {  // which Open MPI refuses unless told twice
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 0);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 0);
  }
  // Seconds that mpirun leaves its ranks between SIGTERM and SIGKILL: enough for a restart file.
  setenv("OMPI_MCA_odls_base_sigkill_timeout", "60", 0);
  if (crowded) setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
}

/// Decides what becomes of each case, says so, and returns those to run. Throws InputError before
/// anything was touched.
std::vector<Todo> decide_all(const std::vector<CasePlan>& plans, const fs::path& series,
                             const Places& places, const RunOptions& options)
{
  std::vector<Todo> todo;
  std::string sentences;
  for (const CasePlan& plan : plans) {
    CaseFolder folder(series / plan.row.id, plan);
    make_folder(folder.path());
    // After SIGKILL of a command its cases stop by themselves: two ranks take some seconds.
    FolderLock lock = lock_of(folder, places, options.resume ? 10.0 : 2.0);
    const Decision decision =
        decide(folder.id(), shown(series), folder.state(), {options.keep, options.resume});
    if (decision.action == Action::refuse) throw InputError(decision.sentence);
    if (!decision.sentence.empty()) sentences += decision.sentence + "\n";
    if (decision.action != Action::keep)
      todo.push_back({std::move(folder), decision, std::move(lock)});
  }
  std::cout << sentences << std::flush;
  return todo;
}

std::string names_of(const std::vector<Todo>& todo)
{
  std::vector<std::string> ids;
  for (const Todo& one : todo) ids.push_back(one.folder.id());
  return joined(ids);
}

std::string resolution_of(const Todo& todo)
{
  for (const auto& [name, value] : todo.folder.plan().asked)
    if (name == "resolution") return " at " + value + " resolution";
  return "";
}

/// What a signal has left of `todo`.
Left left_of(const std::vector<Todo>& todo)
{
  Left left;
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

/// `encase report` in a process of its own, as pictures may take a display made for it; false when
/// it fails.
bool make_report(const Places& places, const RunOptions& options, const fs::path& series,
                 StopSignals& signals)
{
  std::cout << "Making the table" << (options.no_pictures ? "" : " and the pictures") << std::endl;
  std::vector<std::string> words{places.program, "report"};
  if (options.no_pictures) words.push_back("--no-pictures");
  words.push_back(series);
  const pid_t pid = start_program({words, "", "", true, -1});
  int code = 0;
  while (!has_ended(pid, code)) {
    if (!signals.wait(0.2)) continue;
    for (const Process& process : process_tree(pid))
      kill(process.pid, signals.count() > 1 ? SIGKILL : SIGTERM);
  }
  return code == 0;
}

void tell_results(const fs::path& series, const RunOptions& options)
{
  std::cout << "Run folder: " << shown(series) << '\n';
  const auto tell = [&](const char* name, const char* file) {
    if (fs::exists(series / file)) std::cout << name << shown(series / file) << '\n';
  };
  tell("Table:      ", "table.txt");
  if (options.no_pictures) return;
  tell("Report:     ", "report.html");
  tell("Pictures:   ", "figures");
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

  StopSignals signals;
  const int cores = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
  const fs::path series = output_folder(places, options);
  make_folder(series);
  FolderLock series_lock;
  if (!series_lock.take(series / ".lock", 0.5))
    throw InputError("'" + shown(series) + "' is in use by another run, choose another --name");
  std::vector<Todo> todo = decide_all(plans, series, places, options);
  const Schedule schedule = best_schedule(static_cast<int>(todo.size()), cores,
                                          options.rank_count(), options.job_count());
  std::vector<std::string> failed;
  if (!todo.empty()) {
    std::cout << "Running " << names_of(todo) << resolution_of(todo.front())
              << "; at once: " << schedule.jobs << ", MPI ranks each: " << schedule.ranks
              << std::endl;
    set_up_open_mpi(schedule.ranks * schedule.jobs > cores);
    CaseRunner runner(places, schedule,
                      versions_text(version_of_project(places), cores, schedule.ranks,
                                    places.inputs / "packages.txt"),
                      signals);
    failed = runner.run(todo);
  }
  if (!signals.count() && failed.size() < plans.size() &&
      !make_report(places, options, series, signals) && !signals.count())
    failed.push_back("report");
  if (signals.count()) {
    std::cout << stopped_line(left_of(todo)) << std::endl;
    return 128 + signals.first();
  }
  std::cout << std::endl;
  if (!failed.empty()) std::cerr << "Failed: " << joined(failed) << std::endl;
  tell_results(series, options);
  return failed.empty() ? 0 : 1;
}

int list_command(const Places& places, const RunOptions& options)
{
  DeckCatalogue decks(places.inputs);
  list_cases(std::cout, read_catalogue(places, options), decks, options);
  return 0;
}

}  // namespace encased_column
