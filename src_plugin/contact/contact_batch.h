// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/resolve_contact.h"

namespace encased_column {

/// Contacts side by side, so that the vector units of the machine see to several at once: as
/// resolve_contact(), for contacts without rolling resistance.
///
/// add() takes contacts in, resolve() finds forces and moves the springs on; the caller then reads
/// the results, keep()s what the contacts remember and empties the batch with clear().
class ContactBatch {
 public:
  static constexpr int size = 32;

  bool is_full() const { return count_ == size; }
  int count() const { return count_; }
  void clear() { count_ = 0, has_dashpots_ = false; }

  /// A contact of body `i` and body `j`, from whose center to whose it is `apart` [m], that counts
  /// by `share`; a wall has the radius zero, and `apart` ends on its surface. `mass` [kg] is that
  /// of the pair, in all contacts of a batch or, without dashpots, zero in all. They overlap by
  /// `more` [m] than `apart` tells: so may a wall that gives way, by more than a radius.
  [[gnu::always_inline]] void add(int i, int j, double share, const ContactMaterial& material,
                                  const Vec3& apart, const ContactBody& body_i,
                                  const ContactBody& body_j, double mass, double* memory,
                                  double more = 0.0)
  {
    const int n = count_++;
    i_[n] = i;
    j_[n] = j;
    memory_[n] = memory;
    const Vec3 velocity = body_i.velocity - body_j.velocity;
    for (int a = 0; a < 3; ++a) {
      normal_[a][n] = apart(a);
      velocity_[a][n] = velocity(a);
      spin_i_[a][n] = body_i.spin(a);
      spin_j_[a][n] = body_j.spin(a);
      spring_[a][n] = memory[a];
    }
    seen_[n] = memory[3];
    more_[n] = more;
    radius_i_[n] = body_i.radius;
    radius_j_[n] = body_j.radius;
    modulus_[n] = material.modulus;
    ratio_[n] = material.stiffness_ratio;
    friction_[n] = material.friction;
    share_[n] = share;
    if (mass == 0.0) return;
    has_dashpots_ = true;
    mass_[n] = mass;
    damping_normal_[n] = material.damping_normal;
    damping_shear_[n] = material.damping_shear;
  }

  /// The step `dt` [s] that ends at step number `step`; without `advance` the forces of the last
  /// one again, to the last bit. Returns the loss of friction [J], of each contact times its share.
  double resolve(double dt, double step, bool advance)
  {
    dashpot_loss_ = 0.0;
    return has_dashpots_ ? resolve_with_dashpots(dt, step, advance)
                         : resolve_springs(dt, step, advance);
  }
  /// Of the dashpots, of each contact times its share [J].
  double dashpot_loss() const { return dashpot_loss_; }

  int i(int n) const { return i_[n]; }
  int j(int n) const { return j_[n]; }
  /// On i, the opposite on j [N].
  Vec3 force(int n) const { return {force_[0][n], force_[1][n], force_[2][n]}; }
  Vec3 moment_i(int n) const  ///< [N m]
  {
    return {moment_i_[0][n], moment_i_[1][n], moment_i_[2][n]};
  }
  Vec3 moment_j(int n) const  ///< [N m], of a wall without meaning
  {
    return {moment_j_[0][n], moment_j_[1][n], moment_j_[2][n]};
  }
  /// On a wall, about the contact [N m].
  Vec3 moment_on_wall(int) const { return Vec3::Zero(); }
  double normal_force(int n) const { return normal_force_[n]; }
  ContactStiffness stiffness(int n) const { return {normal_stiffness_[n], shear_stiffness_[n]}; }
  /// Writes what the contacts remember.
  void keep(double step) const
  {
    for (int n = 0; n < count_; ++n) keep_one(n, step);
  }

  double share(int n) const { return share_[n]; }
  Vec3 normal(int n) const { return {normal_[0][n], normal_[1][n], normal_[2][n]}; }
  double arm_i(int n) const { return contact_arm(radius_i_[n], overlap_[n]); }  ///< [m]
  /// From the center of i to that of j, or to the wall [m].
  double distance(int n) const { return radius_i_[n] + radius_j_[n] - overlap_[n]; }
  double stored_energy(int n) const  ///< [J]
  {
    return spring_energy(stiffness(n), overlap_[n], {spring_[0][n], spring_[1][n], spring_[2][n]});
  }
  bool is_sliding(int n) const { return part_[n] < 1.0; }
  /// True where the contact was not there a step before step number `step`.
  bool is_new(int n, double step) const { return seen_[n] < step - 1.0; }

 protected:
  void keep_one(int n, double step) const
  {
    double* const memory = memory_[n];
    for (int a = 0; a < 3; ++a) memory[a] = spring_[a][n];
    memory[3] = step;
  }

  double resolve_springs(double dt, double step, bool advance);
  double resolve_with_dashpots(double dt, double step, bool advance);
  template <bool dashpots, bool advance>
  double resolve_as(double dt, double step);

  using Numbers = double[size];
  int count_ = 0;
  bool has_dashpots_ = false;
  double dashpot_loss_ = 0.0;
  int i_[size], j_[size];
  double* memory_[size];
  alignas(64) Numbers normal_[3];  ///< `apart` until resolve()
  Numbers velocity_[3], spin_i_[3], spin_j_[3], spring_[3], seen_, more_;
  Numbers radius_i_, radius_j_, modulus_, ratio_, friction_, share_;
  Numbers mass_, damping_normal_, damping_shear_;
  Numbers cosine_, sine_;  ///< of half the turn about the normal
  Numbers per_length_;     ///< one over the sum of the radii [1/m]
  Numbers overlap_, force_[3], moment_i_[3], moment_j_[3], normal_force_, normal_stiffness_,
      shear_stiffness_, part_;
};

}  // namespace encased_column
