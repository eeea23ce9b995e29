// SPDX-License-Identifier: GPL-2.0-only
#include "host/fix_stop_request.h"

#include "signal_handling.h"

#include <unistd.h>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace encased_column {

namespace {

volatile std::sig_atomic_t stop_asked = 0, save_asked = 0, stop_known = 0;

void say(const char* sentence)
{
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, sentence, std::strlen(sentence));
}

void ask_to_stop(int)
{
  if (stop_known) {
    say("\nSecond signal: ended without a restart file.\n");
    _Exit(EXIT_FAILURE);
  }
  stop_known = 1;
  stop_asked = 1;
  say("\nSignal caught: stops at the next step and writes a restart file.\n");
}

void ask_to_save(int)
{
  save_asked = 1;
}

void handle(int signal, void (*handler)(int))
{
  struct sigaction before {};
  sigaction(signal, nullptr, &before);
  if (signal == SIGHUP && before.sa_handler == SIG_IGN) return;  // started by nohup
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void install_stop_handlers()
{
  handle(SIGINT, ask_to_stop);
  handle(SIGTERM, ask_to_stop);
  handle(SIGHUP, ask_to_stop);
  handle(SIGUSR2, ask_to_stop);
  handle(SIGUSR1, ask_to_save);
}

int take_request()
{
  int request = 0;
  if (stop_asked) request |= StopRequest::stop;
  if (save_asked) request |= StopRequest::save;
  if (request & StopRequest::stop) stop_asked = 0;
  if (request & StopRequest::save) save_asked = 0;
  return request;
}

namespace {

const char* const name = "stop_request";

/// Several ranks exchange requests only every so many steps: an exchange takes longer than a step
/// of few grains.
constexpr int between_talks = 10;

}  // namespace

void FixStopRequest::add_to(LAMMPS_NS::LAMMPS* lmp)
{
  if (lmp->modify->find_fix(name) >= 0) return;
  const char* words[] = {name, "all", name};
  lmp->modify->add_fix(3, const_cast<char**>(words));
}

int FixStopRequest::setmask()
{
  return LAMMPS_NS::FixConst::INITIAL_INTEGRATE;
}

// Before the host asks in this same step whether a restart file is due.
void FixStopRequest::initial_integrate(int)
{
  if (comm->nprocs > 1 && update->ntimestep % between_talks != 0) return;
  int request = take_request();
  if (comm->nprocs > 1) MPI_Allreduce(MPI_IN_PLACE, &request, 1, MPI_INT, MPI_BOR, world);
  if (request == 0) return;
  LAMMPS_NS::SignalHandler::request_write_restart = true;
  if (request & StopRequest::stop) LAMMPS_NS::SignalHandler::request_quit = true;
}

}  // namespace encased_column
