#pragma once

#include "runner/case_folder.h"
#include "runner/case_process.h"
#include "runner/places.h"
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
};

/// Runs cases side by side, tells how far they are, and stops them on a signal.
class CaseRunner {
 public:
  CaseRunner(const Places& places, const Schedule& schedule, std::string versions,
             StopSignals& signals);

  /// Returns the ids of those that failed. After a signal those that still ran have been stopped,
  /// and the rest was not begun.
  std::vector<std::string> run(std::vector<Todo>& todo);

 private:
  void start(Todo& todo);
  void collect();
  void end(const CaseProcess& process, int code);
  void fail(const CaseFolder& folder, const std::string& sentence);
  void watch();
  void obey(int signal);
  void speak();

  const Places& places_;
  Schedule schedule_;
  std::string versions_;
  StopSignals& signals_;
  std::vector<std::unique_ptr<CaseProcess>> running_;
  std::vector<std::string> failed_;
  int all_ = 0, ended_ = 0;
  double brought_ = 0.0;  ///< work that cases which go on had done before, in cases
  bool on_terminal_;
  std::chrono::steady_clock::time_point began_, spoken_;
};

}  // namespace encased_column
