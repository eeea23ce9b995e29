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
    const double hardening = constants.hardening;
    if (!(hardening < stiffness[i]))
      throw InputError("'hardening' must be less than 'modulus' times 'thickness', found " +
                       in_words(hardening) + " and " + in_words(stiffness[i]) + " N/m in the " +
                       names[i] + " direction: write a smaller one");
    // Of a strain past the strength the elastic part is dN / J, the rest is plastic.
    hardening_[i] = hardening / (1.0 - hardening / stiffness[i]);
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

double Cloth::snap_ratio(int direction, const ClothFacet& facet) const
{
  const double strength = this->strength(direction, facet);
  return facet.width[direction] * strength * strength /
         (2.0 * constants_.fracture_energy * stiffness_[direction]);
}

double Cloth::limit(int direction, const ClothFacet& facet, const FacetMemory& memory) const
{
  const double table = curve_[direction].limit(memory.plastic_strain[direction]);
  if (!has_strength(direction)) return table;
  const double past = memory.plastic_strain[direction] - plastic_at_strength(direction, facet);
  const double strength = this->strength(direction, facet);
  return past < 0.0 || tears() ? std::min(table, strength)
                               : strength + hardening_[direction] * past;
}

YieldLine Cloth::line(int direction, const ClothFacet& facet, const FacetMemory& memory) const
{
  constexpr double never = YieldLine::never;
  const double plastic = memory.plastic_strain[direction], left = memory.left();
  if (left < 1.0) return {0.0, left > 0.0 ? -never : never, 0.0, -never};
  YieldLine line = curve_[direction].line(plastic);
  if (!has_strength(direction)) return line;
  const double strength = this->strength(direction, facet);
  const double reached = line.slope > 0.0 ? line.origin + (strength - line.tension) / line.slope
                         : line.tension < strength ? never
                                                   : line.origin;
  if (plastic >= reached)
    return {plastic_at_strength(direction, facet), strength, hardening_[direction],
            tears() ? -never : never};
  line.end = std::min(line.end, reached);
  return line;
}

/// Lets plastic strain grow under a tension [N/m] above its limit; returns the energy per area.
double Cloth::yield(int i, double tension, const ClothFacet& facet, FacetMemory& memory) const
{
  double& plastic = memory.plastic_strain[i];
  const double from = limit(i, facet, memory), strength = this->strength(i, facet);
  double growth = curve_[i].growth(plastic, tension, relaxation_[i]);
  if (has_strength(i) && !tears()) {
    const double past = plastic - plastic_at_strength(i, facet);
    const double behind =
        (tension - strength - hardening_[i] * past) / (relaxation_[i] + hardening_[i]);
    if (past + behind >= 0.0) growth = std::max(behind, 0.0);
  }
  // Before it tears a strip has the plastic strain of its strength, no more.
  if (has_strength(i) && tears() && curve_[i].limit(plastic + growth) > strength)
    growth = curve_[i].growth(plastic, strength, 0.0);
  plastic += growth;
  return 0.5 * (from + limit(i, facet, memory)) * growth;
}

/// The damage that tensions (hoop, axial) of the whole cloth [N/m] ask for by one of them.
double Cloth::damage_of(int i, const double (&whole)[2], const ClothFacet& facet) const
{
  const double strength = this->strength(i, facet);
  if (!has_strength(i) || !(whole[i] > strength)) return 0.0;
  const double contraction = poisson_ * (i == 0 ? 1.0 : stiffness_[1] / stiffness_[0]);
  const double softened = snap_ratio(i, facet) * (whole[i] - contraction * whole[1 - i]);
  return softened < strength ? (whole[i] - strength) / (whole[i] - softened) : 1.0;
}

double Cloth::follow(const ClothAnswer& answer, const ClothFacet& facet, FacetMemory& memory) const
{
  double taken = 0.0;
  const double left = memory.left();
  if (!(left > 0.0)) return taken;
  double whole[2] = {answer.force(0) / left, answer.force(1) / left};
  for (int i = 0; i < 2 && left == 1.0; ++i) {
    if (!(whole[i] > limit(i, facet, memory))) continue;
    const double before = memory.plastic_strain[i];
    taken += yield(i, whole[i], facet, memory);
    whole[i] -= relaxation_[i] * (memory.plastic_strain[i] - before);
  }
  if (!tears()) return taken;
  for (int i = 0; i < 2; ++i)
    memory.damage[i] = std::max(memory.damage[i], damage_of(i, whole, facet));
  const double now = memory.left();
  if (now == 1.0) return taken;
  const double shear = answer.elastic_shear, size = std::abs(shear);
  if (left == 1.0) memory.most_shear = size;
  taken += answer.energy * (1.0 - now / left);
  if (size <= memory.most_shear) return taken;
  const double kept = std::copysign(memory.most_shear, shear);
  memory.slip += shear - kept;
  return taken + 0.5 * answer.force(2) * now / left * (1.0 + kept / shear) * (shear - kept);
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
