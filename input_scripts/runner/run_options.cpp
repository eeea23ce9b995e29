// SPDX-License-Identifier: GPL-2.0-only
#include "runner/run_options.h"

#include "core/input_error.h"
#include "runner/slurm_job.h"

#include <algorithm>

#include <CLI/CLI.hpp>

namespace encased_column {

Settings RunOptions::settings() const
{
  Settings settings;
  for (const std::string& word : set) settings.push_back(read_setting("--set", word));
  return settings;
}

int RunOptions::whole_number(const std::string& option, const std::string& word)
{
  if (word.empty()) return 0;
  const bool whole = word.size() <= 4 && word.front() != '0' &&
                     word.find_first_not_of("0123456789") == std::string::npos;
  if (!whole)
    throw InputError(option + " takes a whole number from 1, found '" + word +
                     "', write for example '" + option + " 2'");
  return std::stoi(word);
}

void RunOptions::check() const
{
  settings();
  rank_count();
  job_count();
  if (is_series() && !cases.empty())
    throw InputError("--series and --case both choose cases, found '" + series + "' and '" +
                     cases.front() + "', give one of them");
  if (retry && !is_series() && !slurm)
    throw InputError(
        "--retry belongs to --series, found it alone, leave it out: without a series cases run "
        "whether they failed before or not");
  if (report_only && (slurm || dry_run || no_report))
    throw InputError(std::string("--report-only makes tables and report and nothing else, found ") +
                     (slurm     ? "--slurm"
                      : dry_run ? "--dry-run"
                                : "--no-report") +
                     " beside it, give one of them");
  if (!slurm_options.empty() && !slurm)
    throw InputError("--slurm-option belongs to --slurm, found '" + slurm_options.front() +
                     "' without it, write both or none");
  for (const std::string& word : slurm_options) sbatch_line(word);
  if (!name.empty() && !is_folder_name(name))
    throw InputError("--name takes letters, digits, '_', '-' and '.', found '" + name +
                     "', write for example '--name trial_2'");
  if (!name.empty() && !out.empty())
    throw InputError("--out and --name both say where results go, found '" + out.string() +
                     "' and '" + name + "', give one of them");
}

void add_run_options(CLI::App& command, RunOptions& options)
{
  const auto repeated = [&](const std::string& name, std::vector<std::string>& target,
                            const std::string& text, const std::string& type) {
    command.add_option(name, target, text)->expected(1)->take_all()->type_name(type);
  };
  command.add_flag("--list", options.list, "list the cases and the variables of their decks");
  repeated("--case", options.cases,
           "run this case (may be repeated; without it: the cases marked * in --list)", "ID");
  command
      .add_option("--series", options.series,
                  "run what is missing of this series of cases, or of 'all': leaves finished ones "
                  "alone, goes on with those that were stopped or killed, longest first")
      ->type_name("NAME");
  command.add_flag("--retry", options.retry,
                   "with --series: run those again that failed before; else they are left so");
  command
      .add_option("--resolution", options.resolution,
                  "quick (default), standard or paper: how fine the grains are")
      ->type_name("R");
  repeated("--set", options.set, "change a variable of the deck (may be repeated)", "NAME=VALUE");
  command
      .add_option(
          "--cases", options.cases_file,
          "cases of your own, a CSV file with the columns of series.csv; without --case: those "
          "it marks, or all of it")
      ->type_name("FILE");
  command
      .add_option("--deck", options.deck,
                  "a deck of your own for the cases; without --case: one case with its defaults")
      ->type_name("FILE");
  command
      .add_option(
          "--name", options.name,
          "results go to runs/NAME (default: default, or the name of the series); its old results "
          "of these cases go, but for a series")
      ->type_name("NAME");
  command.add_option("--out", options.out, "results go to this folder instead")->type_name("DIR");
  command.add_flag("--keep", options.keep,
                   "leave a case alone that has already finished with the same variables");
  command.add_flag(
      "--resume", options.resume,
      "go on with cases that were stopped or killed, from their last restart file, given "
      "the same options again; as --keep for those that have finished");
  command
      .add_option("--ranks", options.ranks,
                  "MPI ranks per case (default: what finishes soonest on this machine)")
      ->type_name("N");
  command.add_option("--jobs", options.jobs, "cases at once (default: number of cores / ranks)")
      ->type_name("N");
  command.add_flag("--dry-run", options.dry_run,
                   "run nothing: tell grains, steps, expected time and disk of each case");
  command.add_flag("--slurm", options.slurm,
                   "run what is missing on a cluster: submits one task for each case to Slurm, and "
                   "a job that makes the report behind them");
  repeated("--slurm-option", options.slurm_options,
           "an option of sbatch for these jobs, as 'partition=long' (may be repeated)", "OPTION");
  command.add_flag("--no-report", options.no_report,
                   "the cases only, beside others in the same folder: neither tables nor report");
  command.add_flag("--report-only", options.report_only,
                   "tables, report and what became of each case, of what has run");
  command.add_flag("--no-pictures", options.no_pictures, "the table only, no report");
  command.footer(
      "Ctrl-C stops cleanly: running cases write a restart file first; once more, and they are "
      "killed.\nKilled cases have a restart file too, by default from every 5000 steps.");
}

double speed_of_ranks(int ranks)
{
  constexpr double speed[] = {1.0, 1.85, 2.6, 3.3};
  return speed[std::clamp(ranks, 1, 4) - 1];
}

Schedule best_schedule(int cases, int cores, int ranks, int jobs)
{
  if (ranks == 0) {
    double shortest = 0.0;
    for (int r = 1; r <= 4 && r <= std::max(cores, 1); ++r) {
      const int at_once = std::max(cores / r, 1);
      const double time = (cases + at_once - 1) / at_once / speed_of_ranks(r);
      if (r > 1 && time >= shortest) continue;
      shortest = time;
      ranks = r;
    }
  }
  if (jobs == 0) jobs = std::max(cores / ranks, 1);
  return {ranks, jobs};
}

}  // namespace encased_column
