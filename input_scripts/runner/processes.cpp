// SPDX-License-Identifier: GPL-2.0-only
#include "runner/processes.h"

#include "core/input_error.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include <sys/prctl.h>
#include <sys/wait.h>

namespace encased_column {

namespace {

// In the child, after fork: only calls that are safe there.
[[noreturn]] void become(char* const* words, char* const* environment, const Start& start,
                         pid_t parent)
{
  if (start.own_session) {
    setsid();
    // Whatever ends us, SIGKILL too, the case does not go on unseen. mpirun passes this signal on
    // to the ranks and ends with them; after SIGTERM it would stay for the seconds it leaves them.
    prctl(PR_SET_PDEATHSIG, SIGUSR2);
    if (getppid() != parent) _exit(126);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGCHLD, SIGUSR1, SIGUSR2}) {
    struct sigaction usual {};
    usual.sa_handler = SIG_DFL;
    sigaction(signal, &usual, nullptr);
  }
  const int nothing = open("/dev/null", O_RDWR);
  if (nothing < 0) _exit(126);
  dup2(nothing, STDIN_FILENO);
  if (!start.screen.empty()) {
    const int file = open(start.screen.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
    if (file < 0) _exit(126);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    if (file > STDERR_FILENO) close(file);
  }
  if (nothing > STDERR_FILENO) close(nothing);
  if (start.kept_file >= 0) fcntl(start.kept_file, F_SETFD, 0);
  if (!start.folder.empty() && chdir(start.folder.c_str()) != 0) _exit(126);
  execvpe(words[0], words, environment);
  _exit(127);
}

std::vector<char*> pointers_to(const std::vector<std::string>& words)
{
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

/// Ours, with `open_mpi_folder` where Open MPI puts the folders of a run.
std::vector<std::string> environment_with(const std::filesystem::path& open_mpi_folder)
{
  const std::string base = "OMPI_MCA_orte_tmpdir_base=";
  std::vector<std::string> all;
  for (char** one = environ; *one; ++one)
    if (open_mpi_folder.empty() || std::string(*one).rfind(base, 0) != 0) all.push_back(*one);
  if (!open_mpi_folder.empty()) all.push_back(base + open_mpi_folder.string());
  return all;
}

}  // namespace

pid_t start_program(const Start& start)
{
  const std::vector<std::string> variables = environment_with(start.open_mpi_folder);
  const std::vector<char*> words = pointers_to(start.words), environment = pointers_to(variables);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0)
    throw InputError("the machine must have room for another process, found '" +
                     std::string(std::strerror(errno)) + "', end some or take fewer --jobs");
  if (child == 0) become(words.data(), environment.data(), start, parent);
  return child;
}

bool has_ended(pid_t pid, int& code)
{
  int status = 0;
  if (waitpid(pid, &status, WNOHANG) != pid) return false;
  code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return true;
}

namespace {

/// Runs `words` to their end; what they write as errors counts as text where `with_errors`.
Answer run_to_end(const std::vector<std::string>& words, bool with_errors)
{
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return {};
  const std::vector<char*> pointers = pointers_to(words);
  const pid_t child = fork();
  if (child == 0) {
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(ends[1], STDOUT_FILENO);
    dup2(with_errors ? ends[1] : nothing, STDERR_FILENO);
    execvp(pointers[0], pointers.data());
    _exit(127);
  }
  close(ends[1]);
  Answer answer;
  char part[4096];
  for (ssize_t size; (size = read(ends[0], part, sizeof part)) > 0;)
    answer.text.append(part, static_cast<std::size_t>(size));
  close(ends[0]);
  int status = 127 << 8;
  if (child > 0) waitpid(child, &status, 0);
  answer.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return answer;
}

}  // namespace

std::string output_of(const std::vector<std::string>& words)
{
  return run_to_end(words, false).text;
}

Answer answer_of(const std::vector<std::string>& words)
{
  return run_to_end(words, true);
}

namespace fs = std::filesystem;

namespace {

struct Stat {
  pid_t parent = 0;
  unsigned long long began = 0;
};

/// The name of a program stands in brackets and may hold brackets and blanks itself.
bool read_stat(const fs::path& folder, Stat& stat)
{
  std::ifstream file(folder / "stat");
  std::string line;
  if (!std::getline(file, line)) return false;
  const std::size_t behind_name = line.rfind(')');
  if (behind_name == std::string::npos) return false;
  std::istringstream words(line.substr(behind_name + 1));
  std::string word;
  for (int field = 3; words >> word; ++field) {
    if (field == 4) stat.parent = static_cast<pid_t>(std::strtol(word.c_str(), nullptr, 10));
    if (field == 22) stat.began = std::strtoull(word.c_str(), nullptr, 10);
  }
  return stat.began > 0;
}

}  // namespace

std::vector<Process> process_tree(pid_t root)
{
  std::multimap<pid_t, Process> children;
  std::vector<Process> tree;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator("/proc", failure)) {
    const pid_t pid = static_cast<pid_t>(std::atol(entry.path().filename().c_str()));
    Stat stat;
    if (pid <= 0 || !read_stat(entry.path(), stat)) continue;
    if (pid == root) tree.push_back({pid, stat.began});
    children.insert({stat.parent, {pid, stat.began}});
  }
  for (std::size_t n = 0; n < tree.size(); ++n) {
    const auto range = children.equal_range(tree[n].pid);
    for (auto child = range.first; child != range.second; ++child) tree.push_back(child->second);
  }
  return tree;
}

std::vector<Process> running(const std::vector<Process>& processes, const fs::path& program)
{
  std::vector<Process> found;
  for (const Process& process : processes) {
    std::error_code failure;
    const fs::path way = fs::path("/proc") / std::to_string(process.pid) / "exe";
    if (fs::equivalent(way, program, failure) && !failure) found.push_back(process);
  }
  return found;
}

}  // namespace encased_column
