// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/parallel_tasks.h"

#include "core/input_error.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <new>
#include <string>
#include <thread>

namespace encased_column {

namespace {

/// The number of the next task, seen by all processes.
class NextTask {
 public:
  NextTask()
      : memory_(mmap(nullptr, sizeof(std::atomic<std::size_t>), PROT_READ | PROT_WRITE,
                     MAP_SHARED | MAP_ANONYMOUS, -1, 0))
  {
    if (memory_ == MAP_FAILED) throw std::bad_alloc();
    number_ = new (memory_) std::atomic<std::size_t>(0);
  }
  ~NextTask() { munmap(memory_, sizeof(std::atomic<std::size_t>)); }
  NextTask(const NextTask&) = delete;
  NextTask& operator=(const NextTask&) = delete;
  std::size_t take() { return (*number_)++; }

 private:
  void* memory_;
  std::atomic<std::size_t>* number_;
};

/// Takes tasks until none is left; the exit code. What a task throws goes into `problems`.
int do_tasks(const std::vector<std::function<void()>>& tasks, NextTask& next, int problems)
{
  try {
    for (std::size_t i = next.take(); i < tasks.size(); i = next.take()) tasks[i]();
  } catch (const std::exception& problem) {
    const std::string sentence = std::string(problem.what()) + '\n';
    if (write(problems, sentence.data(), sentence.size()) < 0) return 2;
    return 1;
  }
  return 0;
}

std::string read_all(int pipe_end)
{
  std::string text;
  char part[512];
  for (ssize_t got = 0; (got = read(pipe_end, part, sizeof part)) > 0;)
    text.append(part, static_cast<std::size_t>(got));
  return text;
}

/// Of a process that did not end well, by what waitpid() says of it.
std::string way_of_ending(int status)
{
  return WIFSIGNALED(status) ? "broke off by signal " + std::to_string(WTERMSIG(status)) + " (" +
                                   strsignal(WTERMSIG(status)) + ')'
                             : "ended with code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

int drawing_processes()
{
  constexpr unsigned most = 4;
  return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, most));
}

void do_in_processes(const std::vector<std::function<void()>>& tasks, int processes)
{
  NextTask next;
  int problems[2];
  if (pipe(problems) != 0) throw std::bad_alloc();
  std::cout << std::flush;
  std::cerr << std::flush;
  std::vector<pid_t> workers;
  for (int i = 0; i < processes; ++i) {
    const pid_t worker = fork();
    if (worker == 0) {
      // Mesa's software renderer would start a thread a core in each.
      if (processes > 1) setenv("LP_NUM_THREADS", "1", 0);
      close(problems[0]);
      const int code = do_tasks(tasks, next, problems[1]);
      std::cout << std::flush;
      _exit(code);  // what the parent holds is its own to end
    }
    if (worker > 0) workers.push_back(worker);
  }
  close(problems[1]);
  if (workers.empty()) {
    close(problems[0]);
    for (const auto& task : tasks) task();
    return;
  }
  const std::string sentences = read_all(problems[0]);
  close(problems[0]);
  std::string broken;
  for (const pid_t worker : workers) {
    int status = 0;
    waitpid(worker, &status, 0);
    if (status != 0) broken = way_of_ending(status);
  }
  if (!sentences.empty()) throw InputError(sentences.substr(0, sentences.find('\n')));
  if (!broken.empty())
    throw InputError(
        "pictures take memory and a display that hold out, found a drawing process that " + broken +
        ", write '--no-pictures' for the tables alone");
}

}  // namespace encased_column
