// SPDX-License-Identifier: GPL-2.0-only
#include "support/run_command.h"

#include "support/small_triaxial.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace encased_column::testing {

namespace fs = std::filesystem;

void prepare_small_cases(const fs::path& folder)
{
  const fs::path inputs = fs::path(ENCASE_SOURCE) / "input_scripts";
  prepare_small_resolution(folder);
  std::ofstream rows(folder / "small.csv");
  rows << "id,deck,default,variables\n";
  for (const std::string kind : {"plain", "encased"}) {
    const std::string name = "triaxial_" + kind;
    fs::copy(inputs / name / (name + ".lmp"), folder / (name + ".lmp"));
    rows << kind << ',' << name
         << ".lmp,0,resolution=small;parameters=study;radius=0.03;height=0.06;porosity=0.40;strain_"
            "end=0.02;"
            "limit=1e-4;restart_every=700\n";
  }
}

RunningCommand::RunningCommand(const fs::path& folder, const std::string& out,
                               const std::vector<std::string>& options)
    : screen_(folder / (out + ".screen"))
{
  setenv("OMPI_MCA_mpi_yield_when_idle", "1", 1);  // more ranks than cores are in order here
  std::vector<std::string> words{ENCASE_COMMAND, "run", "--cases",      "small.csv",
                                 "--out",        out,   "--no-pictures"};
  words.insert(words.end(), options.begin(), options.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("cannot start encase");
  if (pid_ == 0) {
    const int file = open(screen_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    if (chdir(folder.c_str()) == 0) execv(argv[0], argv.data());
    _exit(127);
  }
}

RunningCommand::~RunningCommand()
{
  if (!has_ended()) ::kill(pid_, SIGKILL);
}

bool RunningCommand::has_ended()
{
  int status = 0;
  if (code_ < 0 && waitpid(pid_, &status, WNOHANG) == pid_)
    code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return code_ >= 0;
}

bool RunningCommand::wait_until(const std::function<bool()>& happened)
{
  for (int n = 0; n < 12'000 && !has_ended(); ++n) {
    if (happened()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

void RunningCommand::send(int signal) const
{
  ::kill(pid_, signal);
}

Outcome RunningCommand::end()
{
  while (!has_ended()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return {code_, read_text(screen_)};
}

}  // namespace encased_column::testing
