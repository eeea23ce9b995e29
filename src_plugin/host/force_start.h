// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"
#include "host/host_types.h"

namespace encased_column {

/// How the sums of force and moment of a step start: cleared by the host, with the weight added by
/// its `fix gravity`, or by us for the time of a run, in a pass over the grains that is made
/// anyway.
class ForceStart {
 public:
  /// Before a run. `motion` moves the grains; left to the host where `watched` in every step.
  void take_over(LAMMPS_NS::LAMMPS* lmp, const LAMMPS_NS::Fix* motion, bool watched);
  /// After it: the next may be another fix's.
  void give_back(LAMMPS_NS::LAMMPS* lmp);

  /// Acceleration [m/s^2] that sums start with; null where the host starts them.
  const Vec3* weight() const { return sums_ == Sums::of_host ? nullptr : &weight_; }
  /// Acceleration [m/s^2] of the deck's gravity, whether the host or we apply it.
  const Vec3& gravity() const { return gravity_; }

  /// The pass over the grains has started the sums of the step to come.
  void set_started()
  {
    if (sums_ == Sums::ours) sums_ = Sums::started;
  }
  /// True where sums are still to be started before forces are made: grains that changed place or
  /// rank bring none along.
  bool is_due(bool grains_moved)
  {
    if (sums_ == Sums::of_host) return false;
    const bool started = sums_ == Sums::started;
    sums_ = Sums::ours;
    return !started || grains_moved;
  }

 private:
  enum class Sums { of_host, ours, started };

  Sums sums_ = Sums::of_host;
  Vec3 weight_ = Vec3::Zero(), gravity_ = Vec3::Zero();
};

}  // namespace encased_column
