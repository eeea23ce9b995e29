// SPDX-License-Identifier: GPL-2.0-only
#include "runner/announcement.h"

#include "runner/time_left.h"

#include <algorithm>

namespace encased_column {

namespace {

/// Tables, figures, page and pictures take about this long [s], and so much more for each test: six
/// tests at `quick` took 32 s on 2 cores (README of the project), one took 26 s of one core.
constexpr double seconds_of_pictures = 10.0, seconds_of_a_test = 4.0;

double seconds_to_run(const std::vector<ExpectedCase>& cases, const Schedule& schedule, double rate)
{
  std::vector<double> work, ordered;
  for (const ExpectedCase& one : cases)
    work.push_back(one.size ? one.size->work * (1.0 - one.done) : 0.0);
  for (const std::size_t n : largest_first(work)) ordered.push_back(work[n]);
  return seconds_of_all(ordered, rate / speed_of_ranks(schedule.ranks), schedule.jobs);
}

/// "3 993", or "3 053 to 3 993 grains"; empty where no deck tells it.
std::string grains_of(const std::vector<ExpectedCase>& cases)
{
  std::vector<double> grains;
  for (const ExpectedCase& one : cases)
    if (one.size) grains.push_back(one.size->grains);
  if (grains.empty()) return "";
  const auto [least, most] = std::minmax_element(grains.begin(), grains.end());
  const std::string from = in_thousands(*least), to = in_thousands(*most);
  return " of " + (from == to ? to : from + " to " + to) + " grains";
}

/// "80 MB of 5.0 GB that are free"; what `unknown` of `all` tests take comes on top.
std::string room_for(double bytes, std::size_t unknown, std::size_t all, double free_bytes)
{
  if (unknown == all) return in_bytes(free_bytes) + " are free there";
  return in_bytes(bytes) + (unknown ? " and more of " : " of ") + in_bytes(free_bytes) +
         " that are free";
}

}  // namespace

bool takes_minutes(const std::vector<ExpectedCase>& cases, const Schedule& schedule)
{
  return seconds_to_run(cases, schedule, 1e-6) > 60.0;
}

std::string announcement(const std::vector<ExpectedCase>& cases, const Schedule& schedule,
                         std::optional<double> rate, const Surroundings& around)
{
  double bytes = 0.0;
  std::size_t unknown = 0;
  for (const ExpectedCase& one : cases) {
    bytes += one.size ? one.size->bytes : 0.0;
    unknown += !one.size;
  }
  std::string text =
      std::to_string(cases.size()) + (cases.size() == 1 ? " test" : " tests") + grains_of(cases);
  if (unknown) text += " (" + std::to_string(unknown) + " of unknown size)";
  text += "; results go to " + around.folder + ", " +
          room_for(bytes, unknown, cases.size(), around.free_bytes) + "\n" +
          "Expected on this machine: ";
  if (unknown == cases.size())
    text += "unknown";
  else if (!takes_minutes(cases, schedule))
    text += "a minute at most";
  else
    text += rate ? in_time(seconds_to_run(cases, schedule, *rate)) + " (its speed was measured)"
                 : "unknown, its speed cannot be measured";
  if (unknown && unknown < cases.size()) text += " without what is of unknown size";
  if (around.pictures)
    text += ", then " +
            in_time(seconds_of_pictures + seconds_of_a_test * static_cast<double>(cases.size())) +
            " for tables and pictures";
  return text + "\nCtrl-C stops at any moment, the same command with --resume goes on\n";
}

}  // namespace encased_column
