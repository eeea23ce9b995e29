// SPDX-License-Identifier: GPL-2.0-only
#include "files/vtk_series.h"

#include "core/input_error.h"
#include "files/atomic_file.h"

#include <cstdio>
#include <filesystem>
#include <sstream>

namespace encased_column {

namespace fs = std::filesystem;

VtkSeries read_series(const Options& options, const std::string& usual_name)
{
  const std::string folder = options.word("folder"), name = options.word("name", usual_name);
  if (name.find_first_of("/\\") != std::string::npos)
    throw InputError("'name' must not hold a slash, found '" + name +
                     "', write the path as 'folder ...'");
  return {fs::absolute(folder).string(), name};
}

bool VtkSeries::prepare() const
{
  std::error_code failure;
  fs::create_directories(folder_, failure);
  return write_collection();
}

bool VtkSeries::write_collection() const
{
  return write_whole_file(folder_ + "/" + name_ + ".pvd", collection_.text());
}

std::string VtkSeries::file_of_step(long step) const
{
  char digits[32];
  std::snprintf(digits, sizeof digits, "%09ld", step);
  return name_ + "_" + digits + ".vtp";
}

bool VtkSeries::list(double time, long step)
{
  collection_.add(time, file_of_step(step));
  return write_collection();
}

std::string VtkSeries::saved() const
{
  std::ostringstream lines;
  lines.precision(17);
  for (const PvdEntry& entry : collection_.entries())
    lines << entry.time << ' ' << entry.file << '\n';
  return lines.str();
}

bool VtkSeries::restore(const std::string& saved)
{
  std::istringstream lines(saved);
  double time = 0.0;
  std::string file;
  while (lines >> time && std::getline(lines >> std::ws, file))
    if (fs::exists(folder_ + "/" + file)) collection_.add(time, file);
  return write_collection();
}

}  // namespace encased_column
