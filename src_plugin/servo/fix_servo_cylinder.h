#pragma once

#include "servo/rigid_wall.h"
#include "servo/specimen_side.h"

namespace encased_column {

class FixServoPlaten;

/// A rigid cylinder about the z axis whose radius changes: the confining wall of a plain test.
class FixServoCylinder : public RigidWall, public SpecimenSide {
 public:
  static const KeywordTable keywords;

  FixServoCylinder(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  void init() override;
  double compute_vector(int n) override;

  double enclosed_volume(double z_low, double z_high) const override;
  double cross_section(double) const override { return section_ratio_ * radius_ * radius_; }
  double radius_at(double) const override { return radius_; }
  double confining_stress() const override { return load().force / loaded_area(); }
  double work() const override { return work_on_grains(); }
  bool holds(const double* center) const override;

 protected:
  const KeywordTable& table() const override { return keywords; }
  WallLoad local_load() const override;
  double loaded_area() const override;
  double usual_speed_limit() const override { return 1e-4 * radius_ / update->dt; }
  void advance(WallMover& mover, double distance) override;
  void measure(WallMover& mover) override;

 private:
  Vec3 center_ = Vec3::Zero();
  std::string platen_ids_[2];
  FixServoPlaten* platens_[2] = {nullptr, nullptr};
  double radius_ = 0.0;
  double section_ratio_ = 0.0;  ///< cross section over radius^2: pi less the facets' segments [-]
};

}  // namespace encased_column
