#pragma once

#include "servo/rigid_wall.h"
#include "servo/wall_shape.h"
#include "specimen/lateral_boundary.h"

namespace encased_column {

/// A flat rigid platen across the z axis.
class FixServoPlaten : public RigidWall {
 public:
  static const KeywordTable keywords;

  FixServoPlaten(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  void post_force(int) override { press_grains(); }
  double compute_vector(int n) override;

  double height() const { return plane_.z; }  ///< of its face [m]
  double stress() const;                      ///< on the cross section [Pa]
  bool is_top() const { return plane_.outward > 0.0; }

 protected:
  void find_partners() override;
  bool has_partners() const override;
  double loaded_area() const override;
  double mean_radius() const override;
  void advance(double distance) override { plane_.advance(distance); }
  double position() const override { return plane_.z; }
  void set_position(double z) override { plane_.z = z; }
  void press_grains() override { press_grains_with(plane_); }

 private:
  PlaneShape plane_;
  double area_ = 0.0;
  std::string side_id_;
  LateralBoundary* side_ = nullptr;
};

}  // namespace encased_column
