#include "runner/child_process.h"

#include "core/input_error.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

namespace encased_column {

namespace {

// In the child, after fork: only calls that are safe there.
[[noreturn]] void become(char* const* words, const Start& start, pid_t parent)
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
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGCHLD, SIGUSR2}) {
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
  execvp(words[0], words);
  _exit(127);
}

std::vector<char*> pointers_to(const std::vector<std::string>& words)
{
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

pid_t start_program(const Start& start)
{
  const std::vector<char*> words = pointers_to(start.words);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0)
    throw InputError("the machine must have room for another process, found '" +
                     std::string(std::strerror(errno)) + "', end some or take fewer --jobs");
  if (child == 0) become(words.data(), start, parent);
  return child;
}

bool has_ended(pid_t pid, int& code)
{
  int status = 0;
  if (waitpid(pid, &status, WNOHANG) != pid) return false;
  code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return true;
}

std::string output_of(const std::vector<std::string>& words)
{
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return "";
  const std::vector<char*> pointers = pointers_to(words);
  const pid_t child = fork();
  if (child == 0) {
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(ends[1], STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    execvp(pointers[0], pointers.data());
    _exit(127);
  }
  close(ends[1]);
  std::string output;
  char part[4096];
  for (ssize_t size; (size = read(ends[0], part, sizeof part)) > 0;)
    output.append(part, static_cast<std::size_t>(size));
  close(ends[0]);
  int status = 1;
  if (child > 0) waitpid(child, &status, 0);
  return output;
}

}  // namespace encased_column
