// The host's own sentence about grains that left names the same number twice: it counts them again
// before it compares. This takes its place, found in this library before the host's.
#include "host/host_types.h"

#include "thermo.h"

#include <string>

namespace {

enum Lost { ignored = 0, warned = 1, error = 2 };  // `thermo_modify lost`, in the host's order

}  // namespace

LAMMPS_NS::bigint LAMMPS_NS::Thermo::lost_check()
{
  bigint grains = atom->nlocal;
  MPI_Allreduce(MPI_IN_PLACE, &grains, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  const bigint before = last_natoms;
  last_natoms = grains;
  if (grains >= before || lostflag == ignored) return grains;
  atom->natoms = grains;
  if (lostflag == warned && lostbefore) return grains;
  lostbefore = 1;
  const std::string text = "of " + std::to_string(before) + " grains " + std::to_string(grains) +
                           " are left at step " + std::to_string(update->ntimestep) +
                           ": the others left the box, enlarge it, slow what pushes them, or let "
                           "them go with 'thermo_modify lost ignore'";
  if (lostflag == Lost::error) lmp->error->all(FLERR, text.c_str());
  if (me == 0) lmp->error->warning(FLERR, text.c_str());
  return grains;
}
