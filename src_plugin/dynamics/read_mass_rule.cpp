// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/read_mass_rule.h"

#include "core/input_error.h"
#include "host/contact_law.h"
#include "host/ranks.h"

#include "pair_gran.h"

#include <algorithm>

namespace encased_column {

namespace {

/// With density scaling the types of grains: walls count from the first touch. True masses
/// cannot wait for that.
std::vector<int> types_that_count(LAMMPS_NS::LAMMPS* lmp, bool scales)
{
  const LAMMPS_NS::Atom* const atom = lmp->atom;
  std::vector<double> seen(atom->ntypes, scales ? 0.0 : 1.0);
  for (int i = 0; i < atom->nlocal; ++i) seen[atom->type[i] - 1] = 1.0;
  sum_over_ranks(seen.data(), seen.size(), lmp->world);
  std::vector<int> types;
  for (int t = 0; t < atom->ntypes; ++t)
    if (seen[t] > 0.0) types.push_back(t + 1);
  return types;
}

void refuse_dashpots(LAMMPS_NS::LAMMPS* lmp)
{
  for (const char* name : {"dampingRatioNormal", "dampingRatioShear"}) {
    const PairProperty ratio = read_pair_property(lmp, name, 0.0, false, 0.0);
    for (int i = 1; i <= lmp->atom->ntypes; ++i)
      for (int j = 1; j <= lmp->atom->ntypes; ++j)
        if (ratio.at(i, j) > 0.0)
          throw InputError(std::string("'") + name + "' must be 0 with density scaling, found " +
                           in_words(ratio.at(i, j)) + ", write 'step stable' or no dashpots");
  }
}

}  // namespace

void read_mass_rule(LAMMPS_NS::LAMMPS* lmp, MassScaling::Rule& rule)
{
  auto* pair = dynamic_cast<LAMMPS_NS::PairGran*>(lmp->force->pair);
  rule.rolling = pair && pair->contact_match("rolling_friction", "epsd2");
  const PairProperty modulus = read_pair_property(lmp, "contactModulus", 0.0, true);
  const PairProperty ratio = read_pair_property(lmp, "stiffnessRatio", 0.0, true);
  rule.stiffest_material = 0.0;
  const std::vector<int> types = types_that_count(lmp, rule.scales());
  for (const int i : types)
    for (const int j : types)
      rule.stiffest_material = std::max(
          rule.stiffest_material, modulus.at(i, j) * decisive_ratio(ratio.at(i, j), rule.rolling));
  if (rule.scales()) refuse_dashpots(lmp);
}

}  // namespace encased_column
