// SPDX-License-Identifier: GPL-2.0-only
#include "runner/decided_cases.h"

#include "core/input_error.h"
#include "runner/processes.h"
#include "runner/text_file.h"

#include <unistd.h>

#include <chrono>
#include <iostream>
#include <thread>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

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

}  // namespace

void make_folder(const fs::path& folder)
{
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure || access(folder.c_str(), W_OK | X_OK) != 0)
    throw InputError("cannot write the output folder '" + shown(folder) +
                     "', free it or choose another --name or --out");
}

Decided decide_all(const std::vector<CasePlan>& plans, const fs::path& series, const Places& places,
                   const RunOptions& options)
{
  Decided decided;
  std::string sentences;
  for (const CasePlan& plan : plans) {
    CaseFolder folder(series / plan.row.id, plan);
    make_folder(folder.path());
    // After SIGKILL of a command its cases stop by themselves: two ranks take some seconds.
    FolderLock lock = lock_of(folder, places, options.wishes().resume ? 10.0 : 2.0);
    const Decision decision = decide(folder.id(), shown(series), folder.state(), options.wishes());
    if (decision.action == Action::refuse) throw InputError(decision.sentence);
    if (!decision.sentence.empty()) sentences += decision.sentence + "\n";
    if (decision.action == Action::leave) decided.failed.push_back(folder.id());
    if (decision.action != Action::keep && decision.action != Action::leave)
      decided.todo.push_back({std::move(folder), decision, std::move(lock)});
  }
  std::cout << sentences << std::flush;
  decided.todo = longest_first(std::move(decided.todo));
  return decided;
}

}  // namespace encased_column
