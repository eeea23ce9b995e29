// SPDX-License-Identifier: GPL-2.0-only
#pragma once

namespace encased_column {

/// MPI_Init. A program that no mpirun started stays alone: Open MPI then runs no helper beside it
/// and keeps nothing in the folder for temporary files, where programs started alone would share a
/// folder that the first to end removes under the others.
void begin_mpi(int* argc, char*** argv);

}  // namespace encased_column
