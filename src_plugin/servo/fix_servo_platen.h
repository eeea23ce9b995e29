// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "host/find_fix.h"
#include "servo/rigid_wall.h"
#include "servo/wall_shape.h"
#include "specimen/lateral_boundary.h"
#include "specimen/platen.h"

namespace encased_column {

/// A flat rigid platen across the z axis.
class FixServoPlaten : public RigidWall, public Platen {
 public:
  static const KeywordTable keywords;

  FixServoPlaten(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  void post_force(int) override { press_grains(); }
  double compute_vector(int n) override;

  bool is_top() const override { return plane_.outward > 0.0; }
  double height() const override { return plane_.z; }
  double speed() const override { return RigidWall::speed(); }
  double force() const override { return load().force; }
  double stress() const override;
  double work() const override { return work_on_grains(); }

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
  NamedFix<LateralBoundary> side_;  ///< whose cross section carries the load, or that area
};

}  // namespace encased_column
