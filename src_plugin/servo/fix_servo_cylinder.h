// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "servo/rigid_wall.h"
#include "servo/wall_shape.h"
#include "specimen/lateral_boundary.h"
#include "specimen/platens_of_deck.h"

namespace encased_column {

/// A rigid cylinder about the z axis whose radius changes: the confining wall of a plain test.
class FixServoCylinder : public RigidWall, public LateralBoundary {
 public:
  static const KeywordTable keywords;

  FixServoCylinder(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  void post_force(int) override { press_grains(); }
  double compute_vector(int n) override;

  Vec3 axis() const override { return {cylinder_.x, cylinder_.y, 0.0}; }
  double enclosed_volume(double z_low, double z_high) const override
  {
    return cylinder_.volume(z_low, z_high);
  }
  double cross_section(double) const override { return cylinder_.cross_section(); }
  double radius_at(double) const override { return cylinder_.radius; }
  double confining_stress() const override;
  double work() const override { return work_on_grains(); }
  int count_outside(const double* centers, int count, double z_low, double z_high) const override
  {
    return cylinder_.count_outside(centers, count, z_low, z_high);
  }

 protected:
  void find_partners() override;
  bool has_partners() const override { return platens_.are_there(); }
  double loaded_area() const override;
  double mean_radius() const override { return cylinder_.radius; }
  void advance(double distance) override;
  double position() const override { return cylinder_.radius; }
  void set_position(double radius) override { cylinder_.radius = radius; }
  void press_grains() override { press_grains_with(cylinder_); }

 private:
  CylinderShape cylinder_;
  PlatensOfDeck platens_;
};

}  // namespace encased_column
