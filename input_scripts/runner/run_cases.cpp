// SPDX-License-Identifier: GPL-2.0-only
#include "runner/run_cases.h"

#include "core/input_error.h"
#include "runner/case_shape.h"
#include "runner/text_file.h"

#include <algorithm>
#include <csignal>
#include <iostream>

namespace encased_column {

std::vector<Todo> longest_first(std::vector<Todo> todo)
{
  double known = 0.0, sum = 0.0;
  for (Todo& one : todo) {
    one.work = 0.0;
    try {
      const auto size = expected_size(one.folder.plan());
      if (size) one.work = size->work;
    } catch (const InputError&) {
      // The case itself will refuse what is wrong there, and says where.
    }
    sum += one.work;
    known += one.work > 0.0;
  }
  std::vector<double> left;
  for (Todo& one : todo) {
    if (one.work == 0.0) one.work = known > 0.0 ? sum / known : 1.0;
    const bool goes_on = one.decision.action == Action::resume;
    left.push_back(one.work * (1.0 - (goes_on ? one.folder.progress().fraction : 0.0)));
  }
  std::vector<Todo> ordered;
  for (const std::size_t n : largest_first(left)) ordered.push_back(std::move(todo[n]));
  return ordered;
}

CaseRunner::CaseRunner(const Places& places, const Schedule& schedule, std::string versions,
                       StopSignals& signals)
    : places_(places),
      schedule_(schedule),
      versions_(std::move(versions)),
      signals_(signals)
{
}

std::vector<std::string> CaseRunner::run(std::vector<Todo>& todo)
{
  for (const Todo& one : todo) {
    const bool goes_on = one.decision.action == Action::resume;
    const double brought = goes_on ? one.folder.progress().fraction : 0.0;
    clocks_.push_back({one.work, brought, brought});
  }
  std::size_t next = 0;
  while (!running_.empty() || (next < todo.size() && !signals_.count())) {
    while (!signals_.count() && next < todo.size() &&
           running_.size() < static_cast<std::size_t>(schedule_.jobs)) {
      start(todo[next], clocks_[next]);
      ++next;
    }
    obey(signals_.wait(0.1));
    watch();
    collect();
    speak();
  }
  screen_.clear();
  return failed_;
}

void CaseRunner::start(Todo& todo, CaseClock& clock)
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
        {std::make_unique<CaseProcess>(todo.folder, command, places_.host, std::move(todo.lock)),
         &clock});
    clock.begun = true;
  } catch (const std::exception& problem) {
    say_failure(todo.folder, problem.what());
    clock.ended = true;
  }
}

// What a run used is looked at as soon as it says so: a wrong one need not run to its end.
void CaseRunner::watch()
{
  for (const auto& [process, clock] : running_) {
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
  screen_.clear();
  if (signals_.count() == 1) {
    std::cout << "Stopping: running cases write a restart file first; a second signal kills them"
              << std::endl;
    return;
  }
  for (const auto& [process, clock] : running_) process->kill();
}

void CaseRunner::look_at(const CaseProcess& process, CaseClock& clock)
{
  clock.fraction = std::max(process.folder().progress().fraction, clock.brought);
  clock.seconds = static_cast<double>(process.seconds());
}

void CaseRunner::collect()
{
  for (auto& [process, clock] : running_) {
    int code = 0;
    if (!process->has_ended(code)) continue;
    look_at(*process, *clock);
    end(*process, code);
    process.reset();
    clock->ended = true;
  }
  running_.erase(std::remove_if(running_.begin(), running_.end(),
                                [](const Running& one) { return !one.process; }),
                 running_.end());
}

void CaseRunner::end(const CaseProcess& process, int code)
{
  const CaseFolder& folder = process.folder();
  const bool stopped = code == 0 && folder.was_stopped();
  if (std::count(failed_.begin(), failed_.end(), folder.id())) return;
  if (signals_.count() && (code >= 128 || stopped)) return;
  const std::string log = shown(folder.path() / "log.liggghts");
  if (stopped)
    return say_failure(folder, "ended by a signal that did not come from here, see " + log);
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
  screen_.clear();
  std::cout << "Case " << folder.id() << " finished in "
            << in_time(static_cast<double>(process.seconds())) << std::endl;
}

void CaseRunner::fail(const CaseFolder& folder, const std::string& sentence)
{
  say_failure(folder, sentence);
  try {
    folder.note_failed(sentence);
  } catch (const InputError&) {
    // A full disk fails cases too: what was said must do.
  }
}

void CaseRunner::say_failure(const CaseFolder& folder, const std::string& sentence)
{
  screen_.clear();
  std::string text = sentence;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::cerr << "Case " << folder.id() << " failed: " << text << std::endl;
  failed_.push_back(folder.id());
}

void CaseRunner::speak()
{
  if (running_.empty() || signals_.count() || !screen_.is_due()) return;
  std::vector<RunningCase> cases;
  for (const auto& [process, clock] : running_) {
    look_at(*process, *clock);
    cases.push_back({process->folder().id(), process->folder().progress()});
  }
  screen_.show(progress_lines(cases, clocks_, schedule_.jobs));
}

}  // namespace encased_column
