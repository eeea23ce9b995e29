// SPDX-License-Identifier: GPL-2.0-only
#include "host/messages.h"

#include "compute.h"
#include "fix.h"
#include "output.h"
#include "thermo.h"
#include "universe.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

// Functions of the host and of MPI stand here once more: found in this library before theirs, as
// the linker's rules and MPI's profiling interface allow, they are called in their place.

namespace encased_column {

namespace {

// On every rank; empty where there is none or where every rank has it, as the terminal.
std::string screen_path, log_path;

/// The file behind an open stream, whatever name it was opened by.
std::string path_of(FILE* stream)
{
  std::error_code none;
  const auto link = "/proc/self/fd/" + std::to_string(fileno(stream));
  return std::filesystem::read_symlink(link, none).string();
}

void write_lines_at_once(FILE* stream)
{
  if (!stream) return;
  std::fflush(stream);
  std::setvbuf(stream, nullptr, _IOLBF, BUFSIZ);
  // What another rank puts at the end must not be overwritten.
  const int flags = fcntl(fileno(stream), F_GETFL);
  if (flags >= 0) fcntl(fileno(stream), F_SETFL, flags | O_APPEND);
}

}  // namespace

void secure_output(LAMMPS_NS::LAMMPS* lmp)
{
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  if (lmp->screen != stdout) write_lines_at_once(lmp->screen);
  write_lines_at_once(lmp->logfile);
  screen_path = lmp->screen && lmp->screen != stdout ? path_of(lmp->screen) : "";
  log_path = lmp->logfile ? path_of(lmp->logfile) : "";
  for (std::string* path : {&screen_path, &log_path}) {
    int length = static_cast<int>(path->size());
    MPI_Bcast(&length, 1, MPI_INT, 0, lmp->world);
    path->resize(length);
    MPI_Bcast(path->data(), length, MPI_CHAR, 0, lmp->world);
  }
}

namespace {

/// To the open `stream`, or on a rank that has not opened it to the end of the file at `path`.
void print_line(const std::string& line, FILE* stream, const std::string& path)
{
  FILE* const out = stream || path.empty() ? stream : std::fopen(path.c_str(), "a");
  if (!out) return;
  std::fputs(line.c_str(), out);
  if (!stream) std::fclose(out);
}

}  // namespace

}  // namespace encased_column

// The host ends a run in which one rank alone finds an error by MPI_Abort, before what was printed
// leaves its buffers, and never writes the reason into the log.
void LAMMPS_NS::Error::one(const char* file, int line, const char* reason)
{
  int rank = 0;
  MPI_Comm_rank(world, &rank);
  const std::string text = "ERROR on proc " + std::to_string(rank) + ": " + reason + " (" + file +
                           ":" + std::to_string(line) + ")\n";
  using namespace encased_column;
  print_line(text, screen, screen_path);
  print_line(text, logfile, log_path);
  MPI_Abort(world, 1);
}

extern "C" int MPI_Abort(MPI_Comm world, int code)
{
  std::fflush(nullptr);
  return PMPI_Abort(world, code);
}

// Sentences of the host that send a user of this project the wrong way, and what they should say.
namespace {

struct Sentence {
  const char* of_host;
  const char* ours;
};

constexpr const char* no_other_step =
    "'reset_timestep' must not be used where contacts remember the step, in which a restart file "
    "was read or fixes are defined, write no 'reset_timestep' and count the steps from where they "
    "are";

const Sentence sentences[] = {
    {"In case of restart, command 'reset_timestep' must come immediately before 'run'",
     no_other_step},
    {"Cannot reset timestep with a time-dependent fix defined", no_other_step},
    {"Atom sorting has bin size = 0.0",
     "there must be a grain before the first step, found none, write 'create_packing' or "
     "'create_atoms' before it"},
    {"Cannot read_restart after simulation box is defined",
     "'read_restart' makes the box itself, found one before it, write it in place of 'create_box' "
     "or behind 'clear'"},
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

// Behind the sentence of a fix or a compute the host prints a joke, one time in five, out of memory
// that it has freed: garbage.
namespace {

std::string sentence_of(const char* kind, const char* style, const char* id, const char* reason)
{
  const std::string who = std::string(kind) + ' ' + style + " (id " + id + ')';
  constexpr std::size_t no_reason = 2;  // the host's measure
  return std::strlen(reason) > no_reason ? who + ": " + reason : who + ": illegal command";
}

}  // namespace

void LAMMPS_NS::Error::fix_error(const char* file, int line, Fix* fix, const char* style,
                                 const char* reason)
{
  all(file, line, sentence_of("Fix", style, fix->id, reason).c_str());
}

void LAMMPS_NS::Error::compute_error(const char* file, int line, Compute* compute,
                                     const char* reason)
{
  all(file, line, sentence_of("Compute", compute->style, compute->id, reason).c_str());
}

// The host's own sentence about grains that left names the same number twice: it counts them again
// before it compares.
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
