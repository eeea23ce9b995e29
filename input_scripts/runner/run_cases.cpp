#include "runner/run_cases.h"

#include "core/input_error.h"
#include "runner/text_file.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <iostream>

namespace encased_column {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

CaseRunner::CaseRunner(const Places& places, const Schedule& schedule, std::string versions,
                       StopSignals& signals)
    : places_(places),
      schedule_(schedule),
      versions_(std::move(versions)),
      signals_(signals),
      on_terminal_(isatty(STDOUT_FILENO)),
      began_(Clock::now()),
      spoken_(began_)
{
}

std::vector<std::string> CaseRunner::run(std::vector<Todo>& todo)
{
  all_ = static_cast<int>(todo.size());
  for (const Todo& one : todo)
    if (one.decision.action == Action::resume) brought_ += one.folder.progress().fraction;
  auto next = todo.begin();
  while (!running_.empty() || (next != todo.end() && !signals_.count())) {
    while (!signals_.count() && next != todo.end() &&
           running_.size() < static_cast<std::size_t>(schedule_.jobs))
      start(*next++);
    obey(signals_.wait(0.1));
    watch();
    collect();
    speak();
  }
  if (on_terminal_) std::cout << "\r\033[K" << std::flush;
  return failed_;
}

void CaseRunner::start(Todo& todo)
{
  const bool goes_on = todo.decision.action == Action::resume;
  try {
    if (goes_on)
      todo.folder.make_ready_for(todo.decision.stage);
    else
      todo.folder.fill();
    const auto command = todo.folder.command(places_, schedule_.ranks, todo.decision.stage);
    todo.folder.note_start(versions_, command);
    running_.push_back(
        std::make_unique<CaseProcess>(todo.folder, command, places_.host, std::move(todo.lock)));
  } catch (const std::exception& problem) {
    fail(todo.folder, problem.what());
    ++ended_;
  }
}

// What a run used is looked at as soon as it says so: a wrong one need not run to its end.
void CaseRunner::watch()
{
  for (const auto& process : running_) {
    if (signals_.count()) process->ask_to_stop();
    try {
      process->confirm_variables();
    } catch (const InputError& problem) {
      if (std::count(failed_.begin(), failed_.end(), process->folder().id())) continue;
      process->kill();
      fail(process->folder(), problem.what());
    }
  }
}

void CaseRunner::obey(int signal)
{
  if (!signal) return;
  if (on_terminal_) std::cout << "\r\033[K";
  if (signals_.count() == 1) {
    std::cout << "Stopping: running cases write a restart file first; a second signal kills them"
              << std::endl;
    return;
  }
  for (const auto& process : running_) process->kill();
}

void CaseRunner::collect()
{
  for (auto& process : running_) {
    int code = 0;
    if (!process->has_ended(code)) continue;
    end(*process, code);
    process.reset();
    ++ended_;
  }
  running_.erase(std::remove(running_.begin(), running_.end(), nullptr), running_.end());
}

void CaseRunner::end(const CaseProcess& process, int code)
{
  const CaseFolder& folder = process.folder();
  const bool stopped = code == 0 && folder.was_stopped();
  if (std::count(failed_.begin(), failed_.end(), folder.id())) return;
  if (signals_.count() && (code >= 128 || stopped)) return;
  const std::string log = shown(folder.path() / "log.liggghts");
  if (stopped) return fail(folder, "ended by a signal that did not come from here, see " + log);
  if (code != 0)
    return fail(folder,
                "exit code " + std::to_string(code) + ", see " + log + "\n" + folder.last_words());
  try {
    if (!process.is_confirmed() && !folder.confirm_variables())
      return fail(folder, "it must say which variables it used, found no variables.csv in '" +
                              shown(folder.path()) +
                              "', write 'record_variables file variables.csv' into its deck");
    folder.note_finished(process.seconds());
  } catch (const InputError& problem) {
    return fail(folder, problem.what());
  }
  if (on_terminal_) std::cout << "\r\033[K";
  std::cout << "Case " << folder.id() << " finished in "
            << in_time(static_cast<double>(process.seconds())) << std::endl;
}

void CaseRunner::fail(const CaseFolder& folder, const std::string& sentence)
{
  if (on_terminal_) std::cout << "\r\033[K" << std::flush;
  std::string text = sentence;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::cerr << "Case " << folder.id() << " failed: " << text << std::endl;
  failed_.push_back(folder.id());
}

void CaseRunner::speak()
{
  if (running_.empty() || signals_.count()) return;
  if (seconds_since(spoken_) < (on_terminal_ ? 1.0 : 30.0)) return;
  spoken_ = Clock::now();
  std::vector<RunningCase> cases;
  for (const auto& process : running_)
    cases.push_back({process->folder().id(), process->folder().progress()});
  if (on_terminal_) std::cout << "\r\033[K";
  std::cout << progress_line(cases, ended_, all_, seconds_since(began_), brought_)
            << (on_terminal_ ? "" : "\n") << std::flush;
}

}  // namespace encased_column
