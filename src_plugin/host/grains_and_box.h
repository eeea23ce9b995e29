// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/input_error.h"
#include "core/periodic_box.h"
#include "host/host_types.h"

#include <string>

namespace encased_column {

/// The box as it is now.
inline PeriodicBox box_of(LAMMPS_NS::LAMMPS* lmp)
{
  const LAMMPS_NS::Domain& domain = *lmp->domain;
  PeriodicBox box;
  for (int a = 0; a < 3; ++a) {
    box.low(a) = domain.boxlo[a];
    box.length(a) = domain.boxhi[a] - domain.boxlo[a];
    box.periodic[a] = domain.periodicity[a] != 0;
  }
  return box;
}

/// As the deck's `boundary` writes it, with the periodic ones of `but` turned into `f`.
inline std::string boundary_words(const LAMMPS_NS::Domain& domain, const std::string& but = "")
{
  std::string words;
  for (int a = 0; a < 3; ++a) {
    const bool open = but.find("xyz"[a]) != std::string::npos && domain.periodicity[a];
    const auto letter = [&](int side) { return open ? 'f' : "pfsm"[domain.boundary[a][side]]; };
    words += std::string(a ? " " : "") + letter(0);
    if (letter(1) != letter(0)) words += letter(1);
  }
  return words;
}

/// Throws InputError where the box is periodic along one of `directions` ("xy"), of whose images
/// `style` knows nothing.
inline void require_open_box(LAMMPS_NS::LAMMPS* lmp, const std::string& style,
                             const std::string& directions)
{
  const LAMMPS_NS::Domain& domain = *lmp->domain;
  for (const char direction : directions)
    if (domain.periodicity[direction - 'x'])
      throw InputError("'" + style + "' needs a box that is not periodic along " + direction +
                       ", found 'boundary " + boundary_words(domain) + "', write 'boundary " +
                       boundary_words(domain, directions) + "'");
}

/// Ends the run where the atoms of the deck have no radius and mass, which `fix` needs.
inline void require_grains(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix& fix)
{
  if (lmp->atom->radius_flag && lmp->atom->rmass_flag) return;
  lmp->error->fix_error(FLERR, &fix,
                        ("'" + std::string(fix.style) +
                         "' needs grains with a radius and a mass, found 'atom_style " +
                         lmp->atom->atom_style + "', write 'atom_style granular'")
                            .c_str());
}

/// The host's arrays of owned and ghost grains without its rows of pointers, which cost a loop
/// over many grains a second wait for memory. Not for a rank that has no grain at all.
struct GrainArrays {
  explicit GrainArrays(LAMMPS_NS::Atom* a)
      : x(a->x[0]),
        v(a->v[0]),
        omega(a->omega[0]),
        radius(a->radius),
        mass(a->rmass),
        type(a->type),
        force(a->f[0]),
        moment(a->torque[0]),
        owned(a->nlocal)
  {
  }
  /// Asks for what the contact law needs of a grain besides its center and radius while other work
  /// goes on, for the second level of the cache: the first one has that work. Inline: as it returns
  /// nothing, a call would be left out.
  [[gnu::always_inline]] void fetch_for_law(int i) const
  {
    constexpr int level = 2;
    __builtin_prefetch(type + i, 0, level);
    __builtin_prefetch(v + 3 * i, 0, level);
    __builtin_prefetch(omega + 3 * i, 0, level);
    __builtin_prefetch(force + 3 * i, 1, level);
    __builtin_prefetch(moment + 3 * i, 1, level);
  }
  const double* __restrict x;      ///< [m]
  const double* __restrict v;      ///< [m/s]
  const double* __restrict omega;  ///< [rad/s]
  const double* __restrict radius;
  const double* __restrict mass;
  const int* __restrict type;
  double* __restrict force;   ///< [N]
  double* __restrict moment;  ///< [N m]
  int owned;
};

}  // namespace encased_column
