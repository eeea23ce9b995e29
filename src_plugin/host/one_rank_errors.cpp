#include "host/one_rank_errors.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

// The host ends a run in which one rank alone finds an error by MPI_Abort, before what was printed
// leaves its buffers, and never writes the reason into the log. Both calls are found in this
// library before those of the host and of MPI, which the linker's rules and MPI's profiling
// interface allow.

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
