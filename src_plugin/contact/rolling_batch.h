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
  Vec3 moment_on_wall(int n) const { return torque_.at(n); }  ///< [N m]
  double stored_energy(int n) const                           ///< [J]
  {
    return ContactBatch::stored_energy(n) +
           rolling_energy(shear_stiffness_[n], radius_of_rolling(n), torque_.at(n));
  }
  void keep(double step) const
  {
    for (int n = 0; n < count_; ++n) {
      keep_one(n, step);
      as_vec3(memory_[n] + memory_size) = torque_.at(n);
    }
  }

 private:
  /// rolling_radius(), or that of the grain against a wall [m].
  double radius_of_rolling(int n) const
  {
    return radius_i_[n] * (radius_j_[n] > 0.0 ? radius_j_[n] * per_length_[n] : 1.0);
  }
  double rolling_spring(int n) const  ///< [N m]
  {
    return shear_stiffness_[n] * radius_of_rolling(n) * radius_of_rolling(n);
  }
  double limit(int n, double dt) const  ///< [N m]
  {
    return rolling_limit(rolling_friction_[n], normal_force_[n], radius_of_rolling(n), dt);
  }
  double slide(double dt);
  double roll(double dt, double step);
  double move_on(int n, double dt, double step);

  VectorRow<size> torque_;  ///< that resists rolling [N m]
  Numbers rolling_friction_;
  Numbers square_, from_;  ///< as in RollingTrial
  double rolling_loss_ = 0.0;
};

}  // namespace encased_column
