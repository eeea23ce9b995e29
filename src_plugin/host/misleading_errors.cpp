// Sentences of the host that send a user of this project the wrong way, and what they should say.
// This Error::all is found before the host's, as is Error::one in one_rank_errors.cpp.
#include "host/host_types.h"

#include "output.h"
#include "universe.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

struct Sentence {
  const char* of_host;
  const char* ours;
};

constexpr const char* no_other_step =
    "'reset_timestep' must not be used where contacts remember the step, in which a restart file "
    "was "
    "read or fixes are defined, write no 'reset_timestep' and count the steps from where they are";

const Sentence sentences[] = {
    {"In case of restart, command 'reset_timestep' must come immediately before 'run'",
     no_other_step},
    {"Cannot reset timestep with a time-dependent fix defined", no_other_step},
    {"Atom sorting has bin size = 0.0",
     "there must be a grain before the first step, found none, write 'create_packing' or "
     "'create_atoms' before it"},
    {"Cannot read_restart after simulation box is defined",
     "'read_restart' makes the box itself, found one before it, write it in place of 'create_box' "
     "or "
     "behind 'clear'"},
    {"Run command before simulation box is defined",
     "'run' needs a box with grains, found no box yet, write 'create_box' or 'read_restart' before "
     "it"},
    {"Invalid run command N value",
     "'run' takes a whole number of steps from 0 to 2147483647, found another one, write several "
     "runs for more"},
};

const char* in_our_words(const char* sentence)
{
  for (const Sentence& known : sentences)
    if (std::strcmp(known.of_host, sentence) == 0) return known.ours;
  return sentence;
}

}  // namespace

void LAMMPS_NS::Error::all(const char* file, int line, const char* reason)
{
  MPI_Barrier(world);
  int rank = 0;
  MPI_Comm_rank(world, &rank);
  if (rank == 0)
    for (FILE* out : {screen, logfile})
      if (out) std::fprintf(out, "ERROR: %s (%s:%d)\n", in_our_words(reason), file, line);
  delete output;  // closes what dumps wrote
  std::fflush(nullptr);
  if (universe->nworlds > 1) MPI_Abort(universe->uworld, 1);
  MPI_Finalize();
  std::exit(1);
}
