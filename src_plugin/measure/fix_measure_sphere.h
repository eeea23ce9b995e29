#pragma once

#include "core/keyword_table.h"
#include "host/ignores_velocity.h"
#include "host/contact_probe.h"
#include "host/run_clock.h"
#include "measure/measuring_sphere.h"
#include "output/csv_series.h"
#include "output/vtk_series.h"

#include <memory>
#include <string>
#include <vector>

namespace encased_column {

class FixServoPlaten;

/// `fix measure/sphere`: porosity, coordination, stress and forces in balls that stand still or
/// follow the platens, as rows of a CSV file and points of VTK files.
class FixMeasureSphere : public LAMMPS_NS::Fix,
                         public ContactProbe,
                         public SeriesOwner,
                         public IgnoresVelocity {
 public:
  static const KeywordTable keywords;

  FixMeasureSphere(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void pre_force(int) override;
  void end_of_step() override;
  double compute_array(int sphere, int column) override;
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;
  const VtkSeries* series() const override { return series_.get(); }

  bool wants_contacts(LAMMPS_NS::bigint step) const override;
  void add_contact(const Contact& contact) override;

 private:
  static const std::vector<std::string>& columns();  ///< of a row, with units
  void read_spheres(const Options& options);
  void place_stack();
  void clear_sums();
  void take_sample();
  void warn_of_few_grains();
  void write_row();
  void write_frame();
  void stop(const std::string& path) const;

  std::vector<MeasuringSphere> spheres_;  ///< those that stand still, then the stack
  int stack_ = 0;                         ///< number of those in the stack
  std::string platen_ids_[2];
  FixServoPlaten* platens_[2] = {nullptr, nullptr};  ///< top, bottom

  long row_every_ = 1, frame_every_ = 1;  ///< steps
  bool setting_up_ = false, warned_ = false, sampled_ = false;
  std::vector<int> contacts_of_;
  std::vector<SphereSums> sums_;       ///< of this rank, then of all
  std::vector<double> largest_force_;  ///< [N]
  std::vector<std::vector<double>> rows_;

  CsvSeries file_;
  RunClock clock_;
  std::unique_ptr<VtkSeries> series_;  ///< if VTK files are wanted
};

}  // namespace encased_column
