// SPDX-License-Identifier: GPL-2.0-only
#include "runner/places.h"

#include "core/input_error.h"
#include "runner/processes.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <vector>

#include <sys/utsname.h>

namespace encased_column {

namespace fs = std::filesystem;

Places find_places()
{
  Places places;
  places.program = fs::read_symlink("/proc/self/exe");
  const fs::path folder = places.program.parent_path();
  places.host = folder / "liggghts-encase";
  // ./input_scripts/run says where it lies: a build elsewhere does not know.
  const char* source = std::getenv("ENCASE_SOURCE");
  if (source && *source) places.source = source;
  places.inputs = places.source.empty() ? folder.parent_path() / "share" / "encased-columns"
                                        : places.source / "input_scripts";
  if (!fs::is_regular_file(places.inputs / "series.csv"))
    throw InputError("the program must find its decks in 'share/encased-columns' beside its own " +
                     std::string("folder, found no '") + (places.inputs / "series.csv").string() +
                     "', move both together or build it again");
  return places;
}

std::string versions_text(const std::string& of_project, int cores, int ranks,
                          const std::string& packages_file)
{
  utsname machine{};
  uname(&machine);
  std::string text = "encased columns " + of_project + "\ncores " + std::to_string(cores) +
                     ", ranks " + std::to_string(ranks) + ", " + machine.sysname + " " +
                     machine.release + " " + machine.machine + "\n";
  std::vector<std::string> query{"dpkg-query", "-W", "-f", "${Package} ${Version}\n"};
  std::ifstream packages(packages_file);
  for (std::string line; std::getline(packages, line);) {
    std::istringstream words(line);
    std::string name;
    if (words >> name && name.front() != '#') query.push_back(name);
  }
  return text + (query.size() > 4 ? output_of(query) : "");
}

}  // namespace encased_column
