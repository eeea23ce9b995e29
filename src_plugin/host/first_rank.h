#pragma once

#include "host/host_types.h"

#include <string>

namespace encased_column {

/// `ok` of the first rank, on all ranks.
inline bool on_first_rank_too(LAMMPS_NS::LAMMPS* lmp, bool ok)
{
  int answer = ok;
  MPI_Bcast(&answer, 1, MPI_INT, 0, lmp->world);
  return answer != 0;
}

/// `text` of the first rank, on all ranks.
inline std::string of_first_rank(LAMMPS_NS::LAMMPS* lmp, std::string text)
{
  int size = static_cast<int>(text.size());
  MPI_Bcast(&size, 1, MPI_INT, 0, lmp->world);
  text.resize(static_cast<std::size_t>(size));
  MPI_Bcast(text.data(), size, MPI_CHAR, 0, lmp->world);
  return text;
}

}  // namespace encased_column
