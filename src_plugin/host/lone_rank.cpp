// SPDX-License-Identifier: GPL-2.0-only
#include "host/lone_rank.h"

#include <mpi.h>

#include <cstdlib>

namespace encased_column {

namespace {

/// A variable of the environment while this object lives, unless it is set already.
class PassingVariable {
 public:
  PassingVariable(const char* name, const char* value) : name_(std::getenv(name) ? nullptr : name)
  {
    if (name_) setenv(name_, value, 1);
  }
  PassingVariable(const PassingVariable&) = delete;
  PassingVariable& operator=(const PassingVariable&) = delete;
  ~PassingVariable()
  {
    if (name_) unsetenv(name_);
  }

 private:
  const char* name_;
};

}  // namespace

// Open MPI reads its settings in MPI_Init alone. What the deck starts by `shell` does not get them.
void begin_mpi(int* argc, char*** argv)
{
  if (std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMIX_RANK")) {
    MPI_Init(argc, argv);
    return;
  }
  const PassingVariable alone("OMPI_MCA_ess_singleton_isolated", "1"),
      no_folders("OMPI_MCA_orte_create_session_dirs", "0");
  MPI_Init(argc, argv);
}

}  // namespace encased_column
