// SPDX-License-Identifier: GPL-2.0-only
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace encased_column::testing {

namespace fs = std::filesystem;

namespace {

std::string trimmed(const std::string& line)
{
  const auto first = line.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

// In the child, after fork: only calls that are safe there.
[[noreturn]] void become(char* const* words, const char* folder, const char* screen)
{
  const int file = open(screen, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int nothing = open("/dev/null", O_RDONLY);
  if (file < 0 || nothing < 0 || chdir(folder) != 0) _exit(126);
  dup2(nothing, STDIN_FILENO);
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  execvp(words[0], words);
  _exit(127);
}

}  // namespace

TemporaryFolder::TemporaryFolder()
{
  std::string name = (fs::temp_directory_path() / "encase_test_XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder()
{
  if (::testing::Test::HasFailure()) {
    std::cerr << "kept for a look: " << path_ << "\n";
    return;
  }
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::vector<std::string> Outcome::lines() const
{
  std::vector<std::string> lines;
  std::istringstream stream(output);
  for (std::string line; std::getline(stream, line);) lines.push_back(trimmed(line));
  return lines;
}

double Outcome::value(const std::string& name) const
{
  for (const std::string& line : lines())
    if (line.rfind(name + " ", 0) == 0) return std::strtod(line.c_str() + name.size(), nullptr);
  return std::numeric_limits<double>::quiet_NaN();
}

Outcome run_program(const std::vector<std::string>& words, const fs::path& folder)
{
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const TemporaryFolder own;
  const std::string screen = own.path() / "screen";
  const std::string where = folder;
  // Programs would share one folder of Open MPI's, which the first to end removes under the others.
  setenv("OMPI_MCA_orte_tmpdir_base", own.path().c_str(), 1);

  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start " + words.front());
  if (child == 0) become(argv.data(), where.c_str(), screen.c_str());
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(screen)};
}

Outcome run_deck(const std::string& text, int ranks, const fs::path& folder,
                 const std::vector<std::string>& arguments)
{
  std::ofstream(folder / "in.lmp") << text;
  // Open MPI refuses root unless told twice.
  setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
  setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  // Ranks that wait let others work: on a busy machine five times faster than turning in circles.
  setenv("OMPI_MCA_mpi_yield_when_idle", "1", 1);
  // Behind a rank that ends with an error mpirun would sleep for a second before it ends the
  // others.
  setenv("OMPI_MCA_odls_base_sigkill_timeout", "0", 1);
  // One machine, and a rank alone has no other to look for: half of a short deck's time.
  setenv("OMPI_MCA_pml", "ob1", 1);
  setenv("OMPI_MCA_btl", "self,vader", 1);
  std::vector<std::string> words;
  if (ranks > 1)
    words = {"mpirun", "-np", std::to_string(ranks), "--oversubscribe", "--bind-to", "none"};
  words.insert(words.end(), {ENCASE_PROGRAM, "-in", "in.lmp"});
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program(words, folder);
}

Outcome run_deck(const std::string& text, int ranks)
{
  const TemporaryFolder folder;
  return run_deck(text, ranks, folder.path());
}

std::string read_text(const fs::path& file)
{
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string opening_deck(const std::string& name)
{
  return read_text(fs::path(ENCASE_SOURCE) / "tests/pages/openings" / (name + ".lmp")) + "\n";
}

}  // namespace encased_column::testing
