// SPDX-License-Identifier: GPL-2.0-only
#include "runner/doctor.h"

#include "runner/aligned_text.h"
#include "runner/dry_run.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace encased_column {

namespace {

using Verdict = Finding::Verdict;

/// The last line that is not empty and no frame of dashes or stars.
std::string last_words(const std::string& text)
{
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" -*=\t\r") != std::string::npos) last = line;
  return last;
}

std::string joined_lines(const std::string& text)
{
  std::istringstream lines(text);
  std::string joined;
  for (std::string line; std::getline(lines, line);) joined += (joined.empty() ? "" : ", ") + line;
  return joined;
}

}  // namespace

Finding judge_programs(const Trial& version, const std::string& file)
{
  if (version.code == 0) return {"programs", Verdict::good, joined_lines(version.text)};
  if (version.code == 127)
    return {"programs", Verdict::bad,
            "LIGGGHTS with the plugin must lie beside this program, found no '" + file +
                "', build or install both again"};
  return {"programs", Verdict::bad,
          "LIGGGHTS with the plugin must start, found '" + last_words(version.text) +
              "', install what it names, with Debian's package 'apt-get --fix-broken install'"};
}

Finding judge_mpi(const Trial& start, int ranks)
{
  if (start.code == 0) {
    char seconds[40];
    std::snprintf(seconds, sizeof seconds, "%.1f", start.seconds);
    return {"MPI", Verdict::good,
            "mpirun started " + std::to_string(ranks) + " ranks in " + seconds + " s"};
  }
  if (start.code == 127)
    return {"MPI", Verdict::bad,
            "several ranks take the program mpirun, found none, write 'apt-get install "
            "openmpi-bin', or '--ranks 1' for each run"};
  return {"MPI", Verdict::bad,
          "mpirun must start " + std::to_string(ranks) + " ranks, found '" +
              last_words(start.text) + "', mend that, or write '--ranks 1' for each run"};
}

Finding judge_display(const std::string& problem)
{
  if (problem.empty()) return {"pictures", Verdict::good, "a display can be opened"};
  return {"pictures", Verdict::bad, problem};
}

Finding judge_disk(double free, double needed, const std::string& folder, bool writable)
{
  if (!writable)
    return {"disk", Verdict::bad,
            "results must go where files can be made, found that '" + folder +
                "' is closed, go to a folder of your own or write '--out DIR'"};
  const std::string found = in_bytes(free) + " free for '" + folder + "', ";
  if (free < needed)
    return {"disk", Verdict::bad,
            "the default job leaves " + in_bytes(needed) + ", found " + found +
                "make room or write '--out DIR' with a folder of another disk"};
  return {"disk", Verdict::good, found + "the default job leaves " + in_bytes(needed)};
}

Finding judge_memory(double free, double needed)
{
  if (free <= 0.0) return {"memory", Verdict::note, "this system does not tell how much is free"};
  if (free < needed)
    return {"memory", Verdict::bad,
            "the default job takes " + in_bytes(needed) + " of memory, found " + in_bytes(free) +
                ", end other programs or write '--jobs 1'"};
  return {"memory", Verdict::good,
          in_bytes(free) + " free, the default job takes " + in_bytes(needed)};
}

Finding judge_cores(int cores)
{
  if (cores > 1) return {"cores", Verdict::good, std::to_string(cores) + ", as many tests at once"};
  return {"cores", Verdict::note, "1: tests run one after the other"};
}

Finding judge_slurm(const Trial& ping)
{
  if (ping.code == 127) return {"Slurm", Verdict::note, "not here; --slurm alone needs it"};
  if (ping.code == 0 && ping.text.find(" is UP") != std::string::npos)
    return {"Slurm", Verdict::good, "answers"};
  // Slurm's own words for a machine that has its programs and belongs to no cluster.
  if (ping.text.find("establish a configuration source") != std::string::npos)
    return {"Slurm", Verdict::note, "installed and not set up; --slurm alone needs it"};
  return {"Slurm", Verdict::bad,
          "Slurm must answer, found '" + last_words(ping.text) +
              "', ask those who keep the cluster, or leave --slurm out"};
}

std::string doctor_text(const std::vector<Finding>& findings)
{
  std::vector<std::vector<std::string>> rows;
  long bad = 0;
  for (const Finding& one : findings) {
    const char* verdict = one.verdict == Verdict::good   ? "ok"
                          : one.verdict == Verdict::note ? "-"
                                                         : "FAIL";
    bad += one.verdict == Verdict::bad;
    rows.push_back({verdict, one.what, one.sentence});
  }
  const std::string number = std::to_string(bad);
  return aligned(rows) +
         (bad ? "\n" + number + (bad == 1 ? " thing needs" : " things need") +
                    " mending: what to do stands behind FAIL\n"
              : "\nThis machine has what the runs need: 'encase run' runs the default job\n");
}

double memory_of_case(double grains)
{
  return 45e6 + 1.8e3 * grains;
}

double available_memory(const std::string& text)
{
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    double kilobytes = 0.0;
    if (std::sscanf(line.c_str(), "MemAvailable: %lf kB", &kilobytes) == 1)
      return 1024.0 * kilobytes;
  }
  return 0.0;
}

}  // namespace encased_column
