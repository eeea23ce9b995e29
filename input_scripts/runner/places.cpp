#include "runner/places.h"

#include "core/input_error.h"

#include <cstdlib>

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

}  // namespace encased_column
