// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/case_folder.h"
#include "runner/case_process.h"
#include "runner/places.h"
#include "runner/progress_screen.h"
#include "runner/run_options.h"
#include "runner/stop_signals.h"

#include <memory>
#include <string>
#include <vector>

namespace encased_column {

/// A case to run and what was decided about it.
struct Todo {
  CaseFolder folder;
  Decision decision;
  FolderLock lock;
  double work = 1.0;  ///< of the whole case, in a unit common to all
};

/// `todo` with each case's work, those with most of it left first: what is long and begins last
/// would run alone at the end. A case whose deck does not tell its size counts as the mean.
std::vector<Todo> longest_first(std::vector<Todo> todo);

/// Runs cases side by side, tells how far they are, and stops them on a signal.
class CaseRunner {
 public:
  CaseRunner(const Places& places, const Schedule& schedule, std::string versions,
             StopSignals& signals);

  /// Returns the ids of those that failed. After a signal those that still ran have been stopped,
  /// and the rest was not begun.
  std::vector<std::string> run(std::vector<Todo>& todo);

 private:
  struct Running {
    std::unique_ptr<CaseProcess> process;
    CaseClock* clock;
  };

  void start(Todo& todo, CaseClock& clock);
  static void look_at(const CaseProcess& process, CaseClock& clock);
  void collect();
  void end(const CaseProcess& process, int code);
  /// Says it and notes it.
  void fail(const CaseFolder& folder, const std::string& sentence);
  void say_failure(const CaseFolder& folder, const std::string& sentence);
  void watch();
  void obey(int signal);
  void speak();

  const Places& places_;
  Schedule schedule_;
  std::string versions_;
  StopSignals& signals_;
  std::vector<Running> running_;
  std::vector<std::string> failed_;
  std::vector<CaseClock> clocks_;  ///< of all cases, in their order
  ProgressScreen screen_;
};

}  // namespace encased_column
