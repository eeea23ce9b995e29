#include "files/vtk_series.h"

#include "files/atomic_file.h"

#include <cstdio>
#include <filesystem>
#include <sstream>

namespace encased_column {

namespace fs = std::filesystem;

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
