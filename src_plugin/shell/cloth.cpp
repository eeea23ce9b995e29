// SPDX-License-Identifier: GPL-2.0-only
#include "shell/cloth.h"

namespace encased_column {

namespace {

const char* const names[2] = {"hoop", "axial"};

}  // namespace

Cloth::Cloth(const ClothConstants& constants, const std::array<double, 2>& stiffness,
             double poisson, double shear)
    : constants_(constants),
      stiffness_(stiffness),
      poisson_(poisson)
{
  whole_ = EvenStiffness::of(stiffness[0], stiffness[1], poisson, 1.0);
  // An isotropic shear stiffness differs from the other by round-off at most.
  const double g = 2.0 * shear / whole_.deviatoric;
  if (std::abs(g - 1.0) > 1e-12) whole_ = EvenStiffness::of(stiffness[0], stiffness[1], poisson, g);
  const double across = 1.0 / (1.0 - whole_.poisson * whole_.poisson);
  for (int i = 0; i < 2; ++i) {
    relaxation_[i] = stiffness[i] * across;
    const auto& table = constants.strip[i];
    if (table.empty()) continue;
    check_strip(table, names[i]);
    curve_[i] = StripCurve(table, stiffness[i], names[i]);
    const double strength = constants.strength[i];
    if (strength > 0.0 && strength < table.back().tension && !tears())
      throw InputError(
          "the 'strength' must not be below the last tension of the table of 'strip' "
          "unless the cloth tears there, found " +
          in_words(strength) + " and " + in_words(table.back().tension) + " N/m in the " +
          names[i] + " direction: end the table at the strength or write 'after_strength tear'");
  }
}

bool Cloth::yields() const
{
  for (int i = 0; i < 2; ++i)
    if (has_strength(i) || curve_[i].yields()) return true;
  return false;
}

double Cloth::warned_of(int direction) const
{
  if (has_strength(direction)) return std::numeric_limits<double>::infinity();
  if (constants_.strength[direction] > 0.0) return constants_.strength[direction];
  const auto& table = constants_.strip[direction];
  return table.empty() ? std::numeric_limits<double>::infinity() : table.back().tension;
}

EvenStiffness Cloth::stiffness(const FacetMemory& memory) const
{
  return EvenStiffness::of(stiffness_[0], stiffness_[1], poisson_, whole_.shear,
                           1.0 - memory.damage[0], 1.0 - memory.damage[1]);
}

double Cloth::snap_ratio(int direction, const ClothFacet& facet) const
{
  const double strength = this->strength(direction, facet);
  return facet.width[direction] * strength * strength /
         (2.0 * constants_.fracture_energy * stiffness_[direction]);
}

double Cloth::limit(int direction, const ClothFacet& facet, const FacetMemory& memory) const
{
  const double d = memory.damage[direction];
  const double strength = this->strength(direction, facet);
  // The line of the crack in terms of damage: S = N_u / (1 - d (1 - r)), N = (1 - d) S.
  if (d > 0.0) return (1.0 - d) * strength / (1.0 - d * (1.0 - snap_ratio(direction, facet)));
  const double table = curve_[direction].limit(memory.plastic_strain[direction]);
  return has_strength(direction) ? std::min(table, strength) : table;
}

double Cloth::follow(const PlaneVector& force, const ClothFacet& facet, FacetMemory& memory) const
{
  double taken = 0.0;
  const FacetMemory before = memory;
  for (int i = 0; i < 2; ++i) {
    if (!(force(i) > limit(i, facet, memory))) continue;
    double& plastic = memory.plastic_strain[i];
    double& damage = memory.damage[i];
    double tension = force(i);
    const double strength = this->strength(i, facet);
    if (damage == 0.0) {
      double growth = curve_[i].growth(plastic, tension, relaxation_[i]);
      if (has_strength(i) && !tears())
        growth = std::max(growth, (tension - strength) / relaxation_[i]);
      // Before it tears a strip has the plastic strain of its strength, no more.
      if (has_strength(i) && tears() && curve_[i].limit(plastic + growth) > strength)
        growth = curve_[i].growth(plastic, strength, 0.0);
      const double from = limit(i, facet, memory);
      plastic += growth;
      taken += 0.5 * (from + limit(i, facet, memory)) * growth;
      tension -= relaxation_[i] * growth;
    }
    if (!tears() || !has_strength(i) || (damage == 0.0 && tension <= strength)) continue;
    const double whole = tension / (1.0 - damage);
    const double now = std::min((whole - strength) / (whole * (1.0 - snap_ratio(i, facet))), torn);
    if (now <= damage) continue;
    taken += 0.5 * whole * whole / stiffness_[i] * (now - damage);
    damage = now;
  }
  if (memory.damage == before.damage) return taken;
  // What the shear has stored falls with its stiffness.
  const EvenStiffness then = stiffness(before);
  const double shear = 0.5 * then.deviatoric * then.shear;
  const double left = stiffness(memory).deviatoric / then.deviatoric;
  return taken + 0.5 * force(2) * force(2) / shear * (1.0 - left);
}

void Cloth::require_no_snap_back(const ClothFacet& facet) const
{
  if (!tears()) return;
  for (int i = 0; i < 2; ++i) {
    if (!has_strength(i) || snap_ratio(i, facet) < 1.0) continue;
    throw InputError("facets of a cloth that tears must be narrower than 2 G_f J / N_u^2 = " +
                     in_words(facet.width[i] / snap_ratio(i, facet)) + " m in the " + names[i] +
                     " direction, or they snap back, found " + in_words(facet.width[i]) +
                     " m: use shorter facets or a larger 'fracture_energy'");
  }
}

}  // namespace encased_column
