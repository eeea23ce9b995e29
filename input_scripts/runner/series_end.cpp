// SPDX-License-Identifier: GPL-2.0-only
#include "runner/series_end.h"

#include "runner/case_table.h"
#include "runner/processes.h"
#include "runner/text_file.h"

#include <algorithm>
#include <csignal>
#include <iostream>

namespace encased_column {

namespace fs = std::filesystem;

bool make_report(const Places& places, const RunOptions& options, const fs::path& series,
                 StopSignals& signals)
{
  std::cout << "Making the table" << (options.no_pictures ? "" : " and the pictures") << std::endl;
  std::vector<std::string> words{places.program, "report", "--brief"};
  if (options.no_pictures) words.push_back("--no-pictures");
  words.push_back(series);
  const pid_t pid = start_program({words, "", "", true, -1, ""});
  int code = 0;
  while (!has_ended(pid, code)) {
    if (!signals.wait(0.2)) continue;
    for (const Process& process : process_tree(pid))
      kill(process.pid, signals.count() > 1 ? SIGKILL : SIGTERM);
  }
  return code == 0;
}

bool tell_outcomes(const std::vector<CasePlan>& plans, const fs::path& series)
{
  std::vector<CaseOutcome> outcomes;
  for (const CasePlan& plan : plans)
    outcomes.push_back(outcome_of(CaseFolder(series / plan.row.id, plan), series / "checks.csv"));
  const std::string table = case_table(outcomes);
  write_text_file(series / "cases.txt", table);
  std::cout << table << std::endl;
  return std::all_of(outcomes.begin(), outcomes.end(),
                     [](const CaseOutcome& one) { return one.has_run(); });
}

void tell_results(const fs::path& series, const RunOptions& options)
{
  const bool has_page = !options.no_pictures && fs::exists(series / "report.html");
  const bool has_table = fs::exists(series / "table.txt");
  std::cout << "Tables" << (has_page ? " and pictures" : "") << ": " << shown(series) << '\n';
  if (has_page)
    std::cout << "Open " << shown(series / "report.html") << '\n';
  else if (has_table)
    std::cout << "Read " << shown(series / "table.txt") << '\n';
}

}  // namespace encased_column
