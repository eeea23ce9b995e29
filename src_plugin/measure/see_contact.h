// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "host/contact_observer.h"
#include "measure/seen_contact.h"

namespace encased_column {

/// `contact` with where and how large its grains are; `counter` knows which are of this rank.
inline SeenContact see_contact(const Contact& contact, const ContactCounter& counter,
                               const LAMMPS_NS::Atom& atom)
{
  SeenContact seen{as_vec3(atom.x[contact.i]),
                   atom.radius[contact.i],
                   contact.j < 0,
                   counter.is_here(contact),
                   Vec3::Zero(),
                   0.0,
                   contact.normal,
                   contact.force,
                   contact.arm,
                   contact.length,
                   contact.share,
                   contact.sliding,
                   contact.stored_energy};
  if (contact.j >= 0) {
    seen.at_j = as_vec3(atom.x[contact.j]);
    seen.radius_j = atom.radius[contact.j];
  }
  return seen;
}

}  // namespace encased_column
