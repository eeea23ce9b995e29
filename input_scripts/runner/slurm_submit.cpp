// SPDX-License-Identifier: GPL-2.0-only
#include "runner/slurm_submit.h"

#include "core/input_error.h"
#include "runner/processes.h"
#include "runner/slurm_job.h"
#include "runner/text_file.h"

#include <algorithm>
#include <iostream>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

std::string last_line(std::string text)
{
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t end = text.rfind('\n');
  return end == std::string::npos ? text : text.substr(end + 1);
}

/// The number of the job that sbatch has taken.
std::string submit(const std::vector<std::string>& words)
{
  const Answer answer = answer_of(words);
  if (answer.code == 127)
    throw InputError(
        "--slurm needs the program 'sbatch', found none, log in where jobs are submitted or leave "
        "--slurm out");
  const std::string line = last_line(answer.text);
  if (answer.code != 0)
    throw InputError("--slurm must give jobs that Slurm takes, found '" + line +
                     "', write what the site asks for with --slurm-option");
  return line.substr(0, line.find(';'));  // number, or number;cluster
}

/// The number of the job that makes the report behind `cases`, which are taken back without it.
std::string submit_report(const SlurmJob& job, const std::string& cases)
{
  const fs::path script = job.folder / "slurm/report.sh";
  write_text_file(script, report_script(job));
  try {
    return submit({"sbatch", "--parsable", "--dependency=afterany:" + cases, script});
  } catch (const InputError&) {
    answer_of({"scancel", cases});
    throw;
  }
}

/// The words of a command with the same cases, decks and variables from any folder.
std::vector<std::string> same_command(const Places& places, const RunOptions& options,
                                      const fs::path& series)
{
  std::vector<std::string> words{places.program, "run", "--out", series};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {std::string(name), value});
  };
  if (!options.cases_file.empty()) add("--cases", fs::absolute(options.cases_file));
  if (!options.deck.empty()) add("--deck", fs::absolute(options.deck));
  add("--resolution", options.resolution);
  for (const std::string& one : options.set) add("--set", one);
  return words;
}

}  // namespace

int submit_to_slurm(const Places& places, const RunOptions& options, const fs::path& series,
                    const std::vector<std::string>& missing, const std::vector<CasePlan>& plans)
{
  if (missing.empty()) {
    std::cout << "Nothing is missing: --report-only in place of --slurm makes tables and report"
              << std::endl;
    return 0;
  }
  SlurmJob job;
  job.name = options.is_series() ? options.series : series.filename().string();
  if (job.name.empty()) job.name = "encase";
  job.folder = series;
  job.ids = missing;
  job.ranks = std::max(options.rank_count(), 1);
  job.jobs = options.job_count();
  job.options = options.slurm_options;
  job.source = places.source;
  job.command = same_command(places, options, series);
  job.report = job.command;
  job.command.insert(job.command.end(),
                     {"--resume", "--no-report", "--ranks", std::to_string(job.ranks)});
  job.report.push_back("--report-only");
  if (options.no_pictures) job.report.push_back("--no-pictures");
  for (const CasePlan& plan : plans) job.report.insert(job.report.end(), {"--case", plan.row.id});

  const fs::path folder = series / "slurm";
  fs::create_directories(folder);
  write_text_file(folder / "cases.sh", cases_script(job));
  const std::string cases = submit({"sbatch", "--parsable", folder / "cases.sh"});
  const std::string told = "Submitted job " + cases + " with " + std::to_string(missing.size()) +
                           (missing.size() == 1 ? " task" : " tasks") + " (" + joined(missing) +
                           ")";
  std::string jobs = cases;
  if (options.no_report)
    std::cout << told << '\n';
  else {
    const std::string report = submit_report(job, cases);
    jobs += "," + report;
    std::cout << told << " and job " << report << " for the report behind it\n";
  }
  std::cout << "'squeue -j " << jobs << "' shows them, their words go to " << shown(folder)
            << std::endl;
  return 0;
}

}  // namespace encased_column
