// Where the numbers of the spheres go: CSV, VTK, restart files.
#include "measure/fix_measure_sphere.h"

#include "files/vtk_spheres_writer.h"
#include "host/restart_block.h"

namespace encased_column {

const std::vector<std::string>& FixMeasureSphere::columns()
{
  static const std::vector<std::string> names{"step [-]",
                                              "sphere [-]",
                                              "x [m]",
                                              "y [m]",
                                              "z [m]",
                                              "radius [m]",
                                              "grains [-]",
                                              "porosity [-]",
                                              "porosity_less_overlap [-]",
                                              "coordination_number [-]",
                                              "coordination_number_bearing [-]",
                                              "axial_stress [Pa]",
                                              "radial_stress [Pa]",
                                              "hoop_stress [Pa]",
                                              "stress_xx [Pa]",
                                              "stress_yy [Pa]",
                                              "stress_zz [Pa]",
                                              "stress_xy [Pa]",
                                              "stress_xz [Pa]",
                                              "stress_yz [Pa]",
                                              "fabric_xx [-]",
                                              "fabric_yy [-]",
                                              "fabric_zz [-]",
                                              "fabric_xy [-]",
                                              "fabric_xz [-]",
                                              "fabric_yz [-]",
                                              "sliding_fraction [-]",
                                              "mean_contact_force [N]",
                                              "largest_contact_force [N]"};
  return names;
}

void FixMeasureSphere::write_row()
{
  if (comm->me != 0) return;
  std::vector<double> block;
  for (const std::vector<double>& row : rows_) block.insert(block.end(), row.begin(), row.end());
  if (!file_.append(block)) files_.stop(file_.path());
}

void FixMeasureSphere::write_frame()
{
  if (comm->me != 0 || !series_) return;
  const long step = static_cast<long>(update->ntimestep);
  const std::string path = series_->path_of_step(step);
  if (!write_spheres(path, columns(), rows_) || !series_->list(clock_.now(), step))
    files_.stop(path);
}

double FixMeasureSphere::compute_array(int sphere, int column)
{
  return rows_[sphere][column];
}

/// The time and the rows as they are, then the series as text.
void FixMeasureSphere::write_restart(FILE* file)
{
  if (comm->me != 0) return;
  std::vector<double> numbers{clock_.now()};
  for (const std::vector<double>& row : rows_)
    numbers.insert(numbers.end(), row.begin(), row.end());
  write_block(file, numbers, series_ ? series_->saved() : "");
}

void FixMeasureSphere::restart(char* buffer)
{
  RestartBlock block(buffer);
  clock_.restart(block.take());
  for (std::vector<double>& row : rows_) block.take(row.data(), row.size());
  sampled_ = true;
  if (comm->me != 0) return;
  if (!file_.go_back_to(static_cast<double>(update->ntimestep))) files_.stop(file_.path());
  if (series_ && !series_->restore(block.text()))
    files_.stop(series_->path_of_step(static_cast<long>(update->ntimestep)));
}

}  // namespace encased_column
