// SPDX-License-Identifier: GPL-2.0-only
// What the ranks of a program send each other: counts calls and bytes of the functions that
// LIGGGHTS and the plugin use in steps, by the profiling names of MPI (standard 4.0, section 14.2).
// Stands before the library of MPI by LD_PRELOAD; tests/bench/ranks builds it and divides by the
// steps. At the end the first rank writes messages.csv.
#include <mpi.h>

#include <cstdio>

namespace {

enum Function { send, allreduce, gather, other, functions };
constexpr const char* name[functions] = {"send", "allreduce", "gather", "other"};

double calls[functions], bytes[functions];

void count(Function function, int number, MPI_Datatype type)
{
  int size = 0;
  PMPI_Type_size(type, &size);
  calls[function] += 1.0;
  bytes[function] += static_cast<double>(number) * size;
}

}  // namespace

extern "C" {

int MPI_Send(const void* data, int number, MPI_Datatype type, int to, int tag, MPI_Comm comm)
{
  count(send, number, type);
  return PMPI_Send(data, number, type, to, tag, comm);
}

int MPI_Isend(const void* data, int number, MPI_Datatype type, int to, int tag, MPI_Comm comm,
              MPI_Request* request)
{
  count(send, number, type);
  return PMPI_Isend(data, number, type, to, tag, comm, request);
}

int MPI_Sendrecv(const void* data, int number, MPI_Datatype type, int to, int tag, void* taken,
                 int most, MPI_Datatype of, int from, int other_tag, MPI_Comm comm,
                 MPI_Status* status)
{
  count(send, number, type);
  return PMPI_Sendrecv(data, number, type, to, tag, taken, most, of, from, other_tag, comm, status);
}

int MPI_Allreduce(const void* data, void* sum, int number, MPI_Datatype type, MPI_Op op,
                  MPI_Comm comm)
{
  count(allreduce, number, type);
  return PMPI_Allreduce(data, sum, number, type, op, comm);
}

int MPI_Allgatherv(const void* data, int number, MPI_Datatype type, void* all, const int* numbers,
                   const int* starts, MPI_Datatype of, MPI_Comm comm)
{
  count(gather, number, type);
  return PMPI_Allgatherv(data, number, type, all, numbers, starts, of, comm);
}

int MPI_Bcast(void* data, int number, MPI_Datatype type, int root, MPI_Comm comm)
{
  count(other, number, type);
  return PMPI_Bcast(data, number, type, root, comm);
}

int MPI_Reduce(const void* data, void* sum, int number, MPI_Datatype type, MPI_Op op, int root,
               MPI_Comm comm)
{
  count(other, number, type);
  return PMPI_Reduce(data, sum, number, type, op, root, comm);
}

int MPI_Finalize()
{
  int rank = 0, ranks = 1;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  PMPI_Comm_size(MPI_COMM_WORLD, &ranks);
  double sums[2 * functions], most[2 * functions], own[2 * functions];
  for (int f = 0; f < functions; ++f) own[f] = calls[f], own[functions + f] = bytes[f];
  PMPI_Reduce(own, sums, 2 * functions, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
  PMPI_Reduce(own, most, 2 * functions, MPI_DOUBLE, MPI_MAX, 0, MPI_COMM_WORLD);
  if (FILE* file = rank == 0 ? std::fopen("messages.csv", "w") : nullptr) {
    std::fprintf(file, "function,calls,bytes,most_calls,most_bytes\n");
    for (int f = 0; f < functions; ++f)
      std::fprintf(file, "%s,%.0f,%.0f,%.0f,%.0f\n", name[f], sums[f] / ranks,
                   sums[functions + f] / ranks, most[f], most[functions + f]);
    std::fclose(file);
  }
  return PMPI_Finalize();
}

}  // extern "C"
