// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "host/host_types.h"

#include <mpi.h>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace encased_column {

/// Sums `n` numbers over the ranks, in place, the same on every rank.
inline void sum_over_ranks(double* values, std::size_t n, MPI_Comm world)
{
  MPI_Allreduce(MPI_IN_PLACE, values, static_cast<int>(n), MPI_DOUBLE, MPI_SUM, world);
}

inline double sum_over_ranks(double value, MPI_Comm world)
{
  sum_over_ranks(&value, 1, world);
  return value;
}

inline double max_over_ranks(double value, MPI_Comm world)
{
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, world);
  return value;
}

inline bool on_any_rank(bool here, MPI_Comm world)
{
  return max_over_ranks(here ? 1.0 : 0.0, world) > 0.0;
}

inline double min_over_ranks(double value, MPI_Comm world)
{
  return -max_over_ranks(-value, world);
}

/// The ranks, for kernels that know no MPI.
struct AllRanks {
  MPI_Comm world;

  /// Adds numbers up in place.
  void sum(double* numbers, std::size_t count) const { sum_over_ranks(numbers, count, world); }
  /// The numbers of all on each: `counts[r]` of rank r from `starts[r]` on in `all`.
  void gather(const double* mine, const int* counts, const int* starts, double* all) const
  {
    int me = 0;
    MPI_Comm_rank(world, &me);
    MPI_Allgatherv(mine, counts[me], MPI_DOUBLE, all, counts, starts, MPI_DOUBLE, world);
  }
};

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
