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

/// A fix that looks at every contact of chosen steps. Whoever computes contacts asks each observer
/// once a step and calls those that want it; other steps cost nothing.
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

/// Every fix of `lmp` that is a T, in the deck's order.
template <typename T>
std::vector<T*> fixes_that_are(LAMMPS_NS::LAMMPS* lmp)
{
  std::vector<T*> found;
  for (int n = 0; n < lmp->modify->nfix; ++n)
    if (auto* fix = dynamic_cast<T*>(lmp->modify->fix[n])) found.push_back(fix);
  return found;
}

}  // namespace encased_column
