#pragma once

#include "servo/rigid_wall.h"
#include "servo/specimen_side.h"

namespace encased_column {

/// A flat rigid platen across the z axis.
class FixServoPlaten : public RigidWall {
 public:
  static const KeywordTable keywords;

  FixServoPlaten(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  void init() override;
  double compute_vector(int n) override;

  double height() const { return z_; }           ///< of its face [m]
  double stress() const;                         ///< on the specimen's cross section [Pa]
  bool is_top() const { return outward_ > 0.0; }

 protected:
  const KeywordTable& table() const override { return keywords; }
  WallLoad local_load() const override;
  double loaded_area() const override;
  double usual_speed_limit() const override;
  void advance(WallMover& mover, double distance) override;
  void measure(WallMover& mover) override;

 private:
  double outward_;  ///< +1 above the specimen, -1 below
  double area_ = 0.0;
  std::string side_id_;
  SpecimenSide* side_ = nullptr;
  double z_ = 0.0;
};

}  // namespace encased_column
