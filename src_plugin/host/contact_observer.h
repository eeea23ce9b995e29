// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"
#include "host/host_types.h"

#include <vector>

namespace encased_column {

/// What a grain touches.
enum class ContactKind { grain = 0, wall = 1, sleeve = 2 };

/// One contact as the force computation sees it.
struct Contact {
  int i;                    ///< local index of the grain
  int j;                    ///< of the other grain, -1 for a wall or sleeve
  Vec3 normal;              ///< from i to j
  Vec3 force;               ///< on i [N]
  double arm;               ///< from the center of i to the contact [m]
  double length;            ///< from the center of i to that of j or to the wall [m]
  double normal_stiffness;  ///< [N/m]
  double shear_stiffness;   ///< [N/m]
  double stored_energy;     ///< [J]
  double share;             ///< part of it this rank counts: 1, or 1/2 across a border
  bool sliding;
  ContactKind kind;  ///< of what stands where j is
};

/// A fix that looks at every contact of chosen steps. The contact loops ask each observer once a
/// step and call those that want it; other steps cost nothing.
class ContactObserver {
 public:
  virtual ~ContactObserver() = default;
  virtual bool wants_contacts(LAMMPS_NS::bigint step) const = 0;
  virtual void add_contact(const Contact& contact) = 0;
};

/// Energy the contacts have turned into heat on this rank since the deck began [J].
struct ContactLosses {
  double friction = 0.0;
  double rolling = 0.0;
  double dashpots = 0.0;
};

/// A fix that keeps the account of the contacts' losses.
class ContactLossOwner {
 public:
  virtual ~ContactLossOwner() = default;
  ContactLosses contact_losses;
};

/// The contacts of each grain of this rank. A pair across a border of ranks, or of a periodic box,
/// is seen from both ends, each time with its own grain as i.
class ContactCounter {
 public:
  void start(int grains) { contacts_.assign(grains, 0); }
  void add(const Contact& contact)
  {
    ++contacts_[contact.i];
    if (is_here(contact)) ++contacts_[contact.j];
  }
  /// The other end is a grain of this rank, and not seen from there.
  bool is_here(const Contact& contact) const
  {
    return contact.j >= 0 && contact.j < static_cast<int>(contacts_.size());
  }
  int operator[](int i) const { return contacts_[i]; }
  int grains() const { return static_cast<int>(contacts_.size()); }

 private:
  std::vector<int> contacts_;
};

}  // namespace encased_column
