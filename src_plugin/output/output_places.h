#pragma once

#include "core/input_error.h"
#include "core/keyword_table.h"
#include "host/host_types.h"
#include "output/vtk_series.h"

#include <fstream>
#include <memory>
#include <string>

namespace encased_column {

/// `ok` of the first rank, on all ranks.
inline bool on_first_rank_too(LAMMPS_NS::LAMMPS* lmp, bool ok)
{
  int answer = ok;
  MPI_Bcast(&answer, 1, MPI_INT, 0, lmp->world);
  return answer != 0;
}

/// The series of files that the keywords `folder` and `name` ask for, its folder made on the first
/// rank; on all ranks, throws InputError when it cannot be written.
inline std::unique_ptr<VtkSeries> series_of(LAMMPS_NS::LAMMPS* lmp, const Options& options,
                                            const std::string& usual_name)
{
  const std::string folder = options.word("folder"), name = options.word("name", usual_name);
  if (name.find_first_of("/\\") != std::string::npos)
    throw InputError("'name' must not hold a slash, found '" + name +
                     "', write the path as 'folder ...'");
  auto series = std::make_unique<VtkSeries>(folder, name);
  if (!on_first_rank_too(lmp, lmp->comm->me != 0 || series->prepare()))
    throw InputError("'folder' must be a folder that can be written, found '" + folder +
                     "', write another path or mend its rights");
  return series;
}

/// Throws InputError on all ranks where the first cannot write the file that `keyword` names;
/// `tried` is the path that is tried.
inline void require_writable(LAMMPS_NS::LAMMPS* lmp, const std::string& keyword,
                             const std::string& file, const std::string& tried)
{
  if (!on_first_rank_too(lmp, lmp->comm->me != 0 || std::ofstream(tried, std::ios::app)))
    throw InputError("'" + keyword + "' must be a file that can be written, found '" + file +
                     "', create its folder or give another name");
}

}  // namespace encased_column
