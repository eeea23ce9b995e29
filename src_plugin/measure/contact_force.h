// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <algorithm>
#include <vector>

namespace encased_column {

/// Part of `force` [N] on a grain that its contact's `normal`, unit and outwards, bears [N]; larger
/// than zero when it is pressed.
inline double normal_force(const Vec3& force, const Vec3& normal)
{
  return -force.dot(normal);
}

/// Magnitude of what is left, along the surface [N].
inline double shear_force(const Vec3& force, const Vec3& normal)
{
  return (force - force.dot(normal) * normal).norm();
}

/// Contacts counted by what a grain touches and by the force they bear.
class ContactForces {
 public:
  static constexpr int kinds = 3;  ///< 0 grain, 1 rigid wall, 2 sleeve

  /// Counts contacts that bear each of `levels` [N] or more.
  explicit ContactForces(std::vector<double> levels = {}) : levels_(std::move(levels)) { clear(); }

  void clear()
  {
    sums_.assign(first_level + levels_.size(), 0.0);
    largest_ = 0.0;
  }

  /// A contact of `kind` that bears `force` [N].
  void add(int kind, double force, bool slides)
  {
    sums_[kind] += 1.0;
    sums_[sliding] += slides;
    sums_[force_sum] += force;
    for (std::size_t n = 0; n < levels_.size(); ++n) sums_[first_level + n] += force >= levels_[n];
    largest_ = std::max(largest_, force);
  }

  const std::vector<double>& levels() const { return levels_; }
  double of_kind(int kind) const { return sums_[kind]; }
  double contacts() const { return sums_[0] + sums_[1] + sums_[2]; }
  double above(std::size_t level) const { return sums_[first_level + level]; }
  double share_above(std::size_t level) const { return share(above(level)); }  ///< [-]
  double sliding_fraction() const { return share(sums_[sliding]); }            ///< [-]
  double mean() const { return share(sums_[force_sum]); }                      ///< [N]
  double largest() const { return largest_; }                                  ///< [N]

  /// What adds up over ranks, and what does not.
  std::vector<double>& sums() { return sums_; }
  void set_largest(double force) { largest_ = force; }

 private:
  static constexpr int sliding = kinds, force_sum = kinds + 1, first_level = kinds + 2;
  /// Nothing has no share.
  double share(double part) const { return contacts() > 0.0 ? part / contacts() : 0.0; }

  std::vector<double> levels_, sums_;
  double largest_ = 0.0;
};

}  // namespace encased_column
