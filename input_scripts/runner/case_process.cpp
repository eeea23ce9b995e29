// SPDX-License-Identifier: GPL-2.0-only
#include "runner/case_process.h"

#include "runner/processes.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <thread>

namespace encased_column {

namespace fs = std::filesystem;

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept
{
  std::swap(file_, other.file_);
  return *this;
}

FolderLock::~FolderLock()
{
  if (file_ >= 0) close(file_);
}

// A helper of Open MPI's holds the lock for a moment longer than the run it belonged to.
bool FolderLock::take(const fs::path& file, double seconds)
{
  file_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) return false;
  for (double waited = 0.0; flock(file_, LOCK_EX | LOCK_NB) != 0; waited += 0.05) {
    if (errno != EWOULDBLOCK && errno != EINTR) return true;  // a file system without locks
    if (waited >= seconds) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return true;
}

void FolderLock::note(pid_t pid) const
{
  const std::string text = std::to_string(pid) + "\n";
  if (ftruncate(file_, 0) == 0) [[maybe_unused]]
    const ssize_t written = pwrite(file_, text.data(), text.size(), 0);
}

CaseProcess::CaseProcess(const CaseFolder& folder, const std::vector<std::string>& command,
                         const fs::path& host, FolderLock lock)
    : folder_(&folder),
      host_(host),
      lock_(std::move(lock))
{
  pid_ = start_program(
      {command, folder.path(), folder.path() / "output.txt", true, lock_.file(), open_mpi_.path()});
  lock_.note(pid_);
}

bool CaseProcess::has_ended(int& code) const
{
  return encased_column::has_ended(pid_, code);
}

long CaseProcess::seconds() const
{
  return static_cast<long>(
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count() + 0.5);
}

// Open MPI would kill the ranks a second after a signal to mpirun; the ranks themselves stop at a
// step. A second signal to one of them would end it at once.
void CaseProcess::ask_to_stop()
{
  for (const Process& rank : running(process_tree(pid_), host_))
    if (asked_.insert(rank).second) ::kill(rank.pid, SIGTERM);
}

void CaseProcess::kill() const
{
  const std::vector<Process> tree = process_tree(pid_);
  ::kill(-pid_, SIGKILL);
  for (const Process& process : tree) ::kill(process.pid, SIGKILL);
}

void CaseProcess::confirm_variables()
{
  if (!confirmed_) confirmed_ = folder_->confirm_variables();
}

pid_t process_in(const fs::path& folder, const fs::path& host)
{
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator("/proc", failure)) {
    const pid_t pid = static_cast<pid_t>(std::atol(entry.path().filename().c_str()));
    std::error_code gone;
    if (pid > 0 && fs::equivalent(entry.path() / "cwd", folder, gone) && !gone &&
        fs::equivalent(entry.path() / "exe", host, gone) && !gone)
      return pid;
  }
  return 0;
}

}  // namespace encased_column
