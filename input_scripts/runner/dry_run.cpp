// SPDX-License-Identifier: GPL-2.0-only
#include "runner/dry_run.h"

#include "core/input_error.h"
#include "runner/aligned_text.h"
#include "runner/case_shape.h"
#include "runner/machine_speed.h"
#include "runner/text_file.h"
#include "runner/time_left.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

double work_left(const ExpectedCase& one)
{
  return one.size ? one.size->work * (1.0 - one.done) : 0.0;
}

std::vector<std::string> row_of(const ExpectedCase& one, double seconds)
{
  if (!one.size) return {one.id, "-", "-", "-", "-", one.note};
  return {one.id,           in_thousands(one.size->grains), in_thousands(one.size->steps()),
          in_time(seconds), in_bytes(one.size->bytes),      one.note};
}

std::optional<ExpectedCase> expected_case(const CasePlan& plan, const fs::path& series,
                                          const Wishes& wishes)
{
  const CaseFolder folder(series / plan.row.id, plan);
  const Decision decision = decide(folder.id(), shown(series), folder.state(), wishes);
  if (decision.action == Action::refuse) throw InputError(decision.sentence);
  if (!decision.sentence.empty()) std::cout << decision.sentence << '\n';
  if (decision.action == Action::keep || decision.action == Action::leave) return std::nullopt;
  ExpectedCase one{folder.id(), std::nullopt, 0.0, ""};
  try {
    one.size = expected_size(plan);
    if (!one.size) one.note = "its deck does not tell its size";
  } catch (const InputError& problem) {
    one.note = problem.what();
  }
  if (decision.action == Action::resume) {
    one.done = folder.progress().fraction;
    one.note = std::to_string(static_cast<int>(100.0 * one.done)) + " % are done";
  }
  return one;
}

}  // namespace

double free_bytes_of(fs::path folder)
{
  std::error_code failure;
  while (!fs::exists(folder, failure) && folder.has_relative_path()) folder = folder.parent_path();
  return static_cast<double>(fs::space(folder, failure).available);
}

std::string in_thousands(double number)
{
  std::string digits = std::to_string(std::llround(number));
  for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), " ");
  return digits;
}

std::string in_bytes(double bytes)
{
  char text[40];
  if (bytes < 1e9)
    std::snprintf(text, sizeof text, "%.0f MB", std::ceil(bytes / 1e6));
  else
    std::snprintf(text, sizeof text, "%.1f GB", bytes / 1e9);
  return text;
}

std::string dry_run_table(const std::vector<ExpectedCase>& cases, const Schedule& schedule,
                          double rate, double free_bytes)
{
  const double rank_rate = rate / speed_of_ranks(schedule.ranks);
  std::vector<double> work;
  for (const ExpectedCase& one : cases) work.push_back(work_left(one));
  std::vector<std::vector<std::string>> rows{
      {"case", "grains", "steps", "expected time", "disk", ""}};
  std::vector<double> ordered;
  double bytes = 0.0;
  std::size_t unknown = 0;
  for (const std::size_t n : largest_first(work)) {
    rows.push_back(row_of(cases[n], work[n] * rank_rate));
    ordered.push_back(work[n]);
    bytes += cases[n].size ? cases[n].size->bytes : 0.0;
    unknown += !cases[n].size;
  }
  const std::string number = std::to_string(cases.size());
  std::string text = aligned(rows, {1, 2, 3, 4}) + number +
                     (cases.size() == 1 ? " case" : " cases") +
                     ", at once: " + std::to_string(schedule.jobs) +
                     ", MPI ranks each: " + std::to_string(schedule.ranks) + ": ";
  if (unknown == cases.size())
    text += "time and disk unknown, " + in_bytes(free_bytes) + " are free";
  else
    text += in_time(seconds_of_all(ordered, rank_rate, schedule.jobs)) + ", " + in_bytes(bytes) +
            " of " + in_bytes(free_bytes) + " that are free";
  if (unknown && unknown < cases.size())
    text += "; without " + std::to_string(unknown) + " of unknown size";
  char speed[80];
  std::snprintf(speed, sizeof speed, "%.2f", 1e-6 / rate);
  return text + "\nThis machine takes " + speed +
         " million steps of a grain in a second and rank, measured just now\n";
}

int dry_run(const Places& places, const std::vector<CasePlan>& plans, const RunOptions& options,
            const fs::path& series, int cores)
{
  std::vector<ExpectedCase> cases;
  for (const CasePlan& plan : plans)
    if (auto one = expected_case(plan, series, options.wishes())) cases.push_back(std::move(*one));
  if (cases.empty()) {
    std::cout << "Nothing would run" << std::endl;
    return 0;
  }
  const Schedule schedule = best_schedule(static_cast<int>(cases.size()), cores,
                                          options.rank_count(), options.job_count());
  const int at_once =
      std::min({schedule.jobs, static_cast<int>(cases.size()), std::max(cores, 1)}) *
      schedule.ranks;
  const double rate = measure_machine(places, at_once);
  std::cout << dry_run_table(cases, schedule, rate, free_bytes_of(series)) << std::flush;
  return 0;
}

}  // namespace encased_column
