// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/contact_batch.h"
#include "core/vector_units.h"

namespace encased_column {

/// Contacts side by side with rolling resistance: as resolve_contact<true>().
class RollingBatch : public ContactBatch {
 public:
  [[gnu::always_inline]] void add(int i, int j, double share, const ContactMaterial& material,
                                  const Vec3& apart, const ContactBody& body_i,
                                  const ContactBody& body_j, double mass, double* memory,
                                  double more = 0.0)
  {
    const int n = count_;
    ContactBatch::add(i, j, share, material, apart, body_i, body_j, mass, memory, more);
    turning_.set(n, body_i.spin - body_j.spin);
    torque_.set(n, {memory[memory_size], memory[memory_size + 1], memory[memory_size + 2]});
    rolling_friction_[n] = material.rolling_friction;
  }

  /// As ContactBatch::resolve(); the loss of friction [J] is that of sliding.
  double resolve(double dt, double step, bool advance)
  {
    const double loss = ContactBatch::resolve(dt, step, advance);
    rolling_loss_ = roll(advance ? dt : 0.0, step);
    return loss;
  }

  /// Of rolling, of each contact times its share [J].
  double rolling_loss() const { return rolling_loss_; }
  Vec3 moment_i(int n) const { return ContactBatch::moment_i(n) - torque_.at(n); }  ///< [N m]
  Vec3 moment_j(int n) const { return ContactBatch::moment_j(n) + torque_.at(n); }  ///< [N m]
  Vec3 moment_on_wall(int n) const { return torque_.at(n); }                        ///< [N m]
  double stored_energy(int n) const                                                 ///< [J]
  {
    return ContactBatch::stored_energy(n) +
           rolling_energy(shear_stiffness_[n], radius_of_rolling(n), torque_.at(n));
  }
  void keep(double step) const
  {
    ContactBatch::keep(step);
    for (int n = 0; n < count_; ++n) {
      const Vec3 torque = torque_.at(n);
      for (int a = 0; a < 3; ++a) memory_[n][memory_size + a] = torque(a);
    }
  }

 private:
  double radius_of_rolling(int n) const
  {
    return radius_j_[n] > 0.0 ? rolling_radius(radius_i_[n], radius_j_[n]) : radius_i_[n];
  }
  double roll(double dt, double step);
  double roll_one(int n, double dt, double step);

  VectorRow<size> turning_, torque_;  ///< spin of i less that of j [rad/s]; resisting torque [N m]
  Numbers rolling_friction_;
  double rolling_loss_ = 0.0;
};

}  // namespace encased_column
