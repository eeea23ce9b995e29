// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/relaxed_membrane.h"
#include "shell/strip_curve.h"

#include <algorithm>
#include <array>
#include <vector>

namespace encased_column {

/// What a cloth does where a tension reaches the strength of its direction.
enum class AfterStrength {
  warn,   ///< bears more; the log tells
  yield,  ///< bears no more and stretches on
  tear    ///< softens and parts
};

/// Strip tests and strength of a cloth as a user gives them, (hoop, axial).
struct ClothConstants {
  std::array<std::vector<StripPoint>, 2> strip;  ///< empty: elastic up to the strength
  std::array<double, 2> strength{};              ///< N_u [N/m], 0: none
  AfterStrength after = AfterStrength::warn;
  double hardening = 0.0;  ///< slope of tension over strain past the strength [N/m], with `yield`
  double fracture_energy = 0.0;  ///< G_f, work to part a unit of width [N], read only with `tear`
  double seam = 1.0;             ///< share of the hoop strength on one line along the axis [-]
  double seam_angle = 0.0;       ///< of that line from x [rad]
};

/// What a facet remembers of its past, (hoop, axial).
struct FacetMemory {
  std::array<double, 2> plastic_strain{};  ///< [-]
  std::array<double, 2> damage{};          ///< by the tension of a direction, 0 to 1 [-]
  double slip = 0.0;                       ///< shear strain by which its tear has slid [-]
  double most_shear = 0.0;                 ///< elastic shear strain it had when the tear began [-]

  /// What is left of all its stiffness, of membrane and bending alike: the worse damage counts.
  double left() const { return 1.0 - std::max(damage[0], damage[1]); }
};

/// How a facet stands in a step.
struct ClothAnswer {
  PlaneVector force;     ///< (N_hoop, N_axial, N_shear) [N/m]
  double elastic_shear;  ///< the part of its shear strain that stores energy [-]
  double energy;         ///< stored per area, bending included [J/m^2]
};

/// What sets a facet apart from others of its cloth, (hoop, axial).
struct ClothFacet {
  std::array<double, 2> width{};             ///< of the band in which it tears [m]
  std::array<double, 2> strength{1.0, 1.0};  ///< share of the cloth's: 1, less on a seam [-]
};

/// Irreversible part of a cloth: each direction has a limit of its own, N_hoop and N_axial, which a
/// strip table and a strength give; under it the cloth is elastic (and wrinkles, relaxed_force()).
///
/// At the table's limit plastic strain grows in that direction alone (associated flow of a
/// criterion of largest stress), at the strength it yields, with a hardening of its own or without,
/// tears or is warned of. While it tears
/// the tension falls in a straight line with the opening w of the crack, N = N_u (1 - w / w_c), w_c
/// = 2 G_f / N_u, spread over the width h of a facet (crack band: Bazant and Oh, Mater. Struct. 16
/// (1983) 155-177); unloading is towards no elastic strain e, w = h d e. A damage takes its share
/// of the whole facet, shear, the other direction and bending too: once torn its strain is that of
/// a gap. With the tension S = N / (1 - d) of the whole cloth, r = h N_u^2 / (2 G_f J),
///
///   d = (S - N_u) / (S - r J e),
///
/// which needs r < 1: a wider facet holds more elastic energy than its crack takes (snap-back). The
/// sides of a tear slide on each other: no more elastic shear strain than where it began.
class Cloth {
 public:
  /// Damage at which a direction counts as torn.
  static constexpr double torn = 1.0 - 1e-9;

  Cloth() = default;
  /// `stiffness` J of strips (hoop, axial) [N/m], `poisson` along the axis under hoop tension,
  /// `shear` G t [N/m]. Throws InputError for tables and strengths that contradict each other.
  Cloth(const ClothConstants& constants, const std::array<double, 2>& stiffness, double poisson,
        double shear);

  const ClothConstants& constants() const { return constants_; }
  /// True where facets must remember something.
  bool yields() const;
  bool tears() const { return constants_.after == AfterStrength::tear; }
  /// True where shear is not that of an isotropic membrane.
  bool softens_off_axis() const { return std::abs(whole_.softening) > 1e-12; }

  /// Tension [N/m] of which the log warns: a strength that changes nothing, else the last reading
  /// of the strip test; infinite where there is none.
  double warned_of(int direction) const;

  const EvenStiffness& whole() const { return whole_; }  ///< without damage

  /// Tension [N/m] above which a direction of a facet without damage yields or tears; infinite
  /// where neither can happen.
  double limit(int direction, const ClothFacet& facet, const FacetMemory& memory) const;

  /// The same as a straight line in its plastic strain, up to where the facet has to be looked at:
  /// the next reading, the strength, or always (`end` below zero) where it tears.
  YieldLine line(int direction, const ClothFacet& facet, const FacetMemory& memory) const;
  /// Plastic strain per tension above a line [m/N].
  double growth_rate(int direction, const YieldLine& line) const
  {
    return 1.0 / (relaxation_[direction] + line.slope);
  }

  /// Lets plastic strain, damage and slip follow how a facet stands; returns the energy per area
  /// [J/m^2] that this takes out. Each direction by itself, so with both of them at their limits,
  /// or wrinkled, what is above them falls by a factor of nu or nu^2 from call to call and is gone
  /// after some; never below the limit.
  double follow(const ClothAnswer& answer, const ClothFacet& facet, FacetMemory& memory) const;

  /// Throws InputError where facets so wide would snap back.
  void require_no_snap_back(const ClothFacet& facet) const;

 private:
  double strength(int direction, const ClothFacet& facet) const
  {
    return constants_.strength[direction] * facet.strength[direction];
  }
  double snap_ratio(int direction, const ClothFacet& facet) const;
  double yield(int direction, double tension, const ClothFacet& facet, FacetMemory& memory) const;
  /// Plastic strain at which a direction of a facet has its strength; YieldLine::never where its
  /// table does not get there.
  double plastic_at_strength(int direction, const ClothFacet& facet) const
  {
    return std::min(curve_[direction].growth(0.0, strength(direction, facet), 0.0),
                    YieldLine::never);
  }
  double damage_of(int direction, const double (&whole)[2], const ClothFacet& facet) const;
  bool has_strength(int direction) const
  {
    return constants_.strength[direction] > 0.0 && constants_.after != AfterStrength::warn;
  }

  ClothConstants constants_;
  std::array<StripCurve, 2> curve_;
  std::array<double, 2> stiffness_{};
  std::array<double, 2> relaxation_{};  ///< by which plastic strain lowers the force at most [N/m]
  std::array<double, 2> hardening_{};   ///< past the strength, tension over plastic strain [N/m]
  double poisson_ = 0.0;
  EvenStiffness whole_{};
};

}  // namespace encased_column
