// SPDX-License-Identifier: GPL-2.0-only
#include "runner/slurm_job.h"

#include "core/input_error.h"

#include <algorithm>

namespace encased_column {

namespace {

std::string all_in_shell(const std::vector<std::string>& words)
{
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + in_shell(word);
  return line;
}

std::string head(const SlurmJob& job, const std::string& name, const std::string& output)
{
  return "#SBATCH --job-name=" + in_shell(name) +
         "\n#SBATCH --nodes=1\n#SBATCH --ntasks=" + std::to_string(job.ranks) +
         "\n#SBATCH --open-mode=append\n#SBATCH --output=" +
         in_shell((job.folder / "slurm" / output).string()) + "\n";
}

std::string options_of_site(const SlurmJob& job)
{
  std::string lines;
  for (const std::string& option : job.options) lines += sbatch_line(option) + "\n";
  return lines;
}

std::string environment(const SlurmJob& job)
{
  return job.source.empty() ? "" : "export ENCASE_SOURCE=" + in_shell(job.source) + "\n";
}

}  // namespace

std::string in_shell(const std::string& word)
{
  const auto is_plain = [](unsigned char c) {
    return c < 0x80 && (std::isalnum(c) ||
                        std::string("_-+=./,:%@").find(static_cast<char>(c)) != std::string::npos);
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string sbatch_line(const std::string& option)
{
  const std::string text = option.rfind("--", 0) == 0 ? option.substr(2) : option;
  const std::string name = text.substr(0, text.find('='));
  const bool is_option =
      name.size() > 1 && name.front() != '-' &&
      std::all_of(name.begin(), name.end(),
                  [](unsigned char c) { return std::islower(c) || c == '-'; }) &&
      std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20; });
  if (!is_option)
    throw InputError("--slurm-option takes a long option of sbatch, found '" +
                     option.substr(0, 60) + "', write for example '--slurm-option partition=long'");
  for (const char* own : {"array", "dependency", "nodes", "ntasks", "requeue", "no-requeue",
                          "output", "open-mode", "wrap"})
    if (name == own)
      throw InputError("--slurm-option leaves out what --slurm itself gives, found '" + name +
                       "', leave it out (--ranks and --jobs say how many)");
  return "#SBATCH --" + text;
}

std::string cases_script(const SlurmJob& job)
{
  std::string array = "0-" + std::to_string(job.ids.size() - 1);
  if (job.jobs > 0) array += "%" + std::to_string(job.jobs);
  return "#!/bin/bash\n# Written by `encase run --slurm`: a task for each case, the longest "
         "first.\n" +
         head(job, job.name, "case_%a.txt") + "#SBATCH --array=" + array +
         "\n#SBATCH --requeue\n#SBATCH --signal=B:USR1@120\n" + options_of_site(job) + "cases=(" +
         all_in_shell(job.ids) +
         ")\ncase=${cases[SLURM_ARRAY_TASK_ID]}\nfolder=" + in_shell(job.folder.string()) +
         "/$case\n" + environment(job) +
         "# Before the time of the job ends the case is asked for a restart file, and then goes on "
         "in\n"
         "# another job. SIGTERM reaches it from Slurm itself.\n"
         "trap '[[ -z $! ]] || kill -USR1 $!' USR1\n"
         "trap : TERM\n" +
         all_in_shell(job.command) +
         " --case \"$case\" &\n"
         "wait $!\n"
         "code=$?\n"
         "while kill -0 $! 2>/dev/null; do\n"
         "  wait $!\n"
         "  code=$?\n"
         "done\n"
         "if ((code == 138)) && ls \"$folder\"/restart_* >/dev/null 2>&1; then\n"
         "  exec scontrol requeue \"${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID\"\n"
         "fi\n"
         "exit \"$code\"\n";
}

std::string report_script(const SlurmJob& job)
{
  SlurmJob one = job;
  one.ranks = 1;
  return "#!/bin/bash\n# Written by `encase run --slurm`: tables, report, and what became of each "
         "case.\n" +
         head(one, job.name + "-report", "report.txt") + options_of_site(job) + environment(job) +
         "exec " + all_in_shell(job.report) + "\n";
}

}  // namespace encased_column
