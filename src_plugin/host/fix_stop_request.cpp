#include "host/fix_stop_request.h"

#include "host/stop_request.h"

#include "signal_handling.h"

namespace encased_column {

namespace {

const char* const name = "stop_request";

/// Several ranks speak with one another every so many steps only: that takes longer than a step of
/// few grains.
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
