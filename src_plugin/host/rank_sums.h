#pragma once

#include <mpi.h>

#include <cstddef>

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

}  // namespace encased_column
