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

std::string log_path;  // on every rank, empty without a log

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
  log_path = lmp->logfile ? path_of(lmp->logfile) : "";
  int length = static_cast<int>(log_path.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, lmp->world);
  log_path.resize(length);
  MPI_Bcast(log_path.data(), length, MPI_CHAR, 0, lmp->world);
}

namespace {

/// Into the log, from a rank that has not opened it too.
void write_into_log(FILE* log, const std::string& line)
{
  if (log) {
    std::fputs(line.c_str(), log);
    return;
  }
  FILE* const file = log_path.empty() ? nullptr : std::fopen(log_path.c_str(), "a");
  if (!file) return;
  std::fputs(line.c_str(), file);
  std::fclose(file);
}

}  // namespace

}  // namespace encased_column

void LAMMPS_NS::Error::one(const char* file, int line, const char* reason)
{
  int rank = 0;
  MPI_Comm_rank(world, &rank);
  const std::string text = "ERROR on proc " + std::to_string(rank) + ": " + reason + " (" + file +
                           ":" + std::to_string(line) + ")\n";
  // Other ranks than the first have no screen where it is a file.
  std::fputs(text.c_str(), screen ? screen : stderr);
  encased_column::write_into_log(logfile, text);
  MPI_Abort(world, 1);
}

extern "C" int MPI_Abort(MPI_Comm world, int code)
{
  std::fflush(nullptr);
  return PMPI_Abort(world, code);
}
