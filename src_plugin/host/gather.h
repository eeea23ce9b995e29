#pragma once

#include "host/host_types.h"

#include <type_traits>
#include <vector>

namespace encased_column {

/// The records of all ranks on the first, rank after rank; empty on the others.
template <typename Record>
std::vector<Record> gather_on_first_rank(const std::vector<Record>& mine, LAMMPS_NS::LAMMPS* lmp)
{
  static_assert(std::is_trivially_copyable_v<Record>);
  // Counted in records: an int does not hold the bytes of some ten million.
  const int ranks = lmp->comm->nprocs, count = static_cast<int>(mine.size());
  std::vector<int> counts(ranks), starts(ranks, 0);
  MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, lmp->world);
  for (int rank = 1; rank < ranks; ++rank) starts[rank] = starts[rank - 1] + counts[rank - 1];
  std::vector<Record> all;
  if (lmp->comm->me == 0) all.resize(static_cast<std::size_t>(starts.back()) + counts.back());
  MPI_Datatype record;
  MPI_Type_contiguous(sizeof(Record), MPI_BYTE, &record);
  MPI_Type_commit(&record);
  MPI_Gatherv(mine.data(), count, record, all.data(), counts.data(), starts.data(), record, 0,
              lmp->world);
  MPI_Type_free(&record);
  return all;
}

}  // namespace encased_column
