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

}  // namespace encased_column
