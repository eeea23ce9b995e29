// SPDX-License-Identifier: GPL-2.0-only
#include "support/one_node_slurm.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace encased_column::testing {

namespace fs = std::filesystem;

namespace {

/// A program of an administrator: often not in PATH.
std::string administrators(const std::string& name)
{
  for (const char* folder : {"/usr/sbin/", "/usr/bin/", "/usr/local/sbin/"})
    if (fs::exists(folder + name)) return folder + name;
  return "";
}

/// A port that nobody listens on.
int free_port()
{
  const int end = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  const bool bound = bind(end, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
                     getsockname(end, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  close(end);
  return bound ? ntohs(address.sin_port) : 0;
}

std::string name_of_machine()
{
  char name[256] = "";
  gethostname(name, sizeof name - 1);
  const std::string whole = name;
  return whole.substr(0, whole.find('.'));
}

}  // namespace

OneNodeSlurm::OneNodeSlurm(const fs::path& folder) : folder_(folder)
{
  const std::string munged = administrators("munged"), controller = administrators("slurmctld"),
                    node = administrators("slurmd");
  if (munged.empty() || controller.empty() || node.empty()) {
    missing_ =
        "found no munged, slurmctld and slurmd: apt-get install --no-install-recommends "
        "slurm-wlm munge";
    return;
  }
  write_configuration();
  const std::string here = folder_.string() + "/";
  setenv("SLURM_CONF", (here + "slurm.conf").c_str(), 1);
  start({munged, "--foreground", "--force", "--key-file=" + here + "munge.key",
         "--socket=" + here + "munge.socket", "--pid-file=" + here + "munge.pid",
         "--log-file=" + here + "munge.log", "--seed-file=" + here + "munge.seed"});
  for (int n = 0; n < 200 && !fs::exists(here + "munge.socket"); ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  start({controller, "-D", "-c"});
  start({node, "-D", "-c", "-N", name_of_machine()});
  for (int n = 0; n < 100; ++n) {
    if (is_idle()) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  missing_ = "its node does not become idle: " + ask({"sinfo"}).output;
}

OneNodeSlurm::~OneNodeSlurm()
{
  for (auto pid = programs_.rbegin(); pid != programs_.rend(); ++pid) {
    kill(*pid, SIGTERM);
    int status = 0;
    for (int n = 0; waitpid(*pid, &status, WNOHANG) != *pid; ++n) {
      if (n == 250) kill(*pid, SIGKILL);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  unsetenv("SLURM_CONF");
}

// A job that is put in the queue again begins no earlier than its credential has expired: 120 s by
// default, 5 at least. proctrack/linuxproc and task/none need no rights on control groups.
void OneNodeSlurm::write_configuration() const
{
  fs::create_directories(folder_ / "state");
  fs::create_directories(folder_ / "spool");
  const std::string here = folder_.string() + "/", user = std::to_string(geteuid()),
                    machine = name_of_machine();
  std::ofstream(here + "munge.key") << std::string(128, 'k');
  chmod((here + "munge.key").c_str(), 0600);
  std::ofstream(here + "slurm.conf")
      << "ClusterName=test\nSlurmctldHost=" << machine << "(127.0.0.1)\nSlurmUser=" << user
      << "\nSlurmdUser=" << user << "\nSlurmctldPort=" << free_port()
      << "\nSlurmdPort=" << free_port() << "\nAuthType=auth/munge\nAuthInfo=socket=" << here
      << "munge.socket,cred_expire=5\nStateSaveLocation=" << here
      << "state\nSlurmdSpoolDir=" << here << "spool\nSlurmctldPidFile=" << here
      << "slurmctld.pid\nSlurmdPidFile=" << here << "slurmd.pid\nSlurmctldLogFile=" << here
      << "slurmctld.log\nSlurmdLogFile=" << here
      << "slurmd.log\nProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\nMpiDefault=none\n"
         "ReturnToService=2\nKillWait=2\nSchedulerType=sched/backfill\n"
         "SchedulerParameters=sched_interval=1,sched_min_interval=0,bf_interval=1,"
         "batch_sched_delay=0\nSelectType=select/cons_tres\nSelectTypeParameters=CR_Core\n"
         "NodeName="
      << machine << " NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN\n"
      << "PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP\n";
}

void OneNodeSlurm::start(const std::vector<std::string>& words)
{
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const std::string screen = folder_ / "daemons.screen";
  const pid_t pid = fork();
  if (pid == 0) {
    const int file = open(screen.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    execv(argv[0], argv.data());
    _exit(127);
  }
  if (pid > 0) programs_.push_back(pid);
}

bool OneNodeSlurm::is_idle() const
{
  return ask({"sinfo", "-h", "-o", "%T"}).lines() == std::vector<std::string>{"idle"};
}

}  // namespace encased_column::testing
