// SPDX-License-Identifier: GPL-2.0-only
#include "core/program_options.h"
#include "host/fix_stop_request.h"
#include "host/lone_rank.h"
#include "plugin_entry.h"
#include "style_table.h"

#include "error.h"
#include "input.h"
#include "lammps.h"
#include "signal_handling.h"
#include "update.h"

#include <mpi.h>

#include <cstdio>
#include <cstring>
#include <iostream>
#include <new>
#include <string>

using namespace encased_column;

namespace {

bool is_one_of(const char* word, std::initializer_list<const char*> words)
{
  for (const char* candidate : words)
    if (std::strcmp(word, candidate) == 0) return true;
  return false;
}

/// One line per style, keyword and column of a table, in the form of the user pages' tables.
void print_styles(std::ostream& out)
{
  for (const Style& style : style_table()) {
    if (!style.maker.keywords) continue;
    out << (style.maker.create.index() == 0 ? "fix " : "command ") << style.name << "\n";
    for (const Keyword& k : style.maker.keywords->keywords())
      out << "| `" << k.name << "` | " << k.values << " | " << k.unit << " | " << k.meaning
          << " |\n";
    if (!style.maker.tables) continue;
    for (const TableText& table : style.maker.tables()) {
      out << "table " << table.file << "\n";
      for (const ColumnText& c : table.columns)
        out << "| `" << c.name << "` | " << c.unit << " | " << c.meaning << " |\n";
    }
  }
}

/// What this program was made for and with; MPI as it is here.
void print_version(std::ostream& out)
{
  char mpi[MPI_MAX_LIBRARY_VERSION_STRING] = "";
  int length = 0;
  MPI_Get_library_version(mpi, &length);
  const std::string library(mpi, static_cast<std::size_t>(length));
  out << "host: " << ENCASE_HOST << "\ncompiler: " << ENCASE_COMPILER
      << "\nMPI: " << library.substr(0, library.find_first_of(",\n")) << "\n";
}

/// Tells in screen and log that a signal has ended the run: the exit code is 0 all the same.
void tell_if_stopped(LAMMPS_NS::LAMMPS& lammps)
{
  if (!LAMMPS_NS::SignalHandler::request_quit) return;
  for (std::FILE* out : {lammps.screen, lammps.logfile})
    if (out)
      std::fprintf(out, "Stopped by a signal at step " BIGINT_FORMAT ", with a restart file\n",
                   lammps.update->ntimestep);
}

}  // namespace

int main(int argc, char** argv)
{
  if (argc > 1 && is_one_of(argv[1], {"-styles", "-version"})) {  // also where MPI does not start
    is_one_of(argv[1], {"-styles"}) ? print_styles(std::cout) : print_version(std::cout);
    return 0;
  }
  install_stop_handlers();  // a signal may come while MPI begins
  begin_mpi(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);

  if (rank == 0 && argc > 1 && is_one_of(argv[1], {"-help", "-h"})) {
    std::cout << "pair_style gran model linear tangential history [rolling_friction epsd2]\n";
    for (const ProgramOption& option : program_options)
      std::cout << option.name << ": " << option.meaning << "\n";
    print_styles(std::cout);
    std::cout << std::flush;
  }

  {
    LAMMPS_NS::LAMMPS lammps(argc, argv, MPI_COMM_WORLD);
    register_styles(&lammps);
    try {
      lammps.input->file();
    } catch (const std::bad_alloc&) {
      lammps.error->one(FLERR,
                        "the command above needs more memory than there is, write fewer or coarser "
                        "grains, or run on more machines");
    }
    tell_if_stopped(lammps);
  }
  MPI_Finalize();
  return 0;
}
