// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/resolve_contact.h"
#include "shell/sleeve_contacts.h"

#include <array>
#include <vector>

namespace encased_column {

/// A few grains that fly about in a barrel of shell facets too narrow at its ends to let them out.
/// Nothing holds it and nothing pulls: the kernels of the sleeve and of the contacts alone, put
/// together as the host's step does, without damping.
class BagOfGrains {
 public:
  explicit BagOfGrains(const ContactMaterial& material);

  /// One step; returns the energy [J] at its start, losses included.
  double step();

  Vec3 linear_momentum() const;
  Vec3 angular_momentum() const;  ///< about the origin [N m s]
  double momentum_size() const;   ///< sum of m |v| of the grains [N s]
  double losses() const { return losses_; }
  long sleeve_contacts() const { return sleeve_contacts_; }  ///< counted in each step

 private:
  struct Grain {
    Vec3 x, v, w, force, moment, listed;
  };

  void press_sleeve();
  void press_pairs();
  void list_again();
  void book(const ContactAction& action);

  static constexpr int grains = 4;
  static constexpr double radius = 0.014, mass = 0.03, margin = 0.004;
  static constexpr double inertia = 0.4 * mass * radius * radius;

  ContactMaterial material_;
  ShellModel model_;
  SleeveContacts contacts_;
  std::array<Grain, grains> grain_;
  double sleeve_memory_[grains][memory_size_rolling] = {};
  double pair_memory_[grains][grains][memory_size_rolling] = {};
  double dt_ = 0.0, stored_ = 0.0, losses_ = 0.0;
  long step_ = 0, sleeve_contacts_ = 0;
};

}  // namespace encased_column
