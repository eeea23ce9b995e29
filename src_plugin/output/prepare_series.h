#pragma once

#include "core/input_error.h"
#include "host/host_types.h"
#include "output/vtk_series.h"

#include <string>

namespace encased_column {

/// Prepares `series` in `folder` on the first rank; on all ranks, throws InputError when it cannot
/// be written.
inline void prepare_on_first_rank(LAMMPS_NS::LAMMPS* lmp, const VtkSeries& series,
                                  const std::string& folder)
{
  int usable = lmp->comm->me != 0 || series.prepare();
  MPI_Bcast(&usable, 1, MPI_INT, 0, lmp->world);
  if (!usable)
    throw InputError("'folder' must be a folder that can be written, found '" + folder +
                     "', write another path or mend its rights");
}

}  // namespace encased_column
