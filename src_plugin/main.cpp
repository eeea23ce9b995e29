#include "plugin_entry.h"
#include "style_table.h"

#include "input.h"
#include "signal_handling.h"

#include <mpi.h>

#include <csignal>
#include <cstring>
#include <iostream>

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

// As in the host's own program: Ctrl-C and kill stop at the next step and write a restart file,
// the user signal writes one and goes on.
void install_signal_handlers()
{
  struct sigaction stop {};
  stop.sa_handler = LAMMPS_NS::SignalHandler::int_handler;
  sigemptyset(&stop.sa_mask);
  sigaction(SIGINT, &stop, nullptr);
  sigaction(SIGTERM, &stop, nullptr);

  struct sigaction save {};
  save.sa_handler = LAMMPS_NS::SignalHandler::usr1_handler;
  sigemptyset(&save.sa_mask);
  sigaction(SIGUSR1, &save, nullptr);
}

}  // namespace

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);

  if (argc > 1 && is_one_of(argv[1], {"-styles", "-help", "-h"})) {
    if (rank == 0) {
      if (!is_one_of(argv[1], {"-styles"}))
        std::cout << "pair_style gran model linear tangential history [rolling_friction epsd2]\n";
      print_styles(std::cout);
    }
    if (is_one_of(argv[1], {"-styles"})) {
      MPI_Finalize();
      return 0;
    }
    std::cout << std::flush;
  }

  install_signal_handlers();
  {
    LAMMPS_NS::LAMMPS lammps(argc, argv, MPI_COMM_WORLD);
    register_styles(&lammps);
    lammps.input->file();
  }
  MPI_Finalize();
  return 0;
}
