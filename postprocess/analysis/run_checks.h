// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "analysis/sampled_curve.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// Width [-] of axial strain over which a check averages.
constexpr double check_averaging_width = 0.01;

/// What the checks of one test look at; all samples of the shear stage, in order.
struct ShearRecord {
  double target_confining_stress;        ///< sigma3 the servo holds [Pa]
  std::vector<double> axial_strain;      ///< [-]
  std::vector<double> confining_stress;  ///< [Pa]
  std::vector<double> stress_top;        ///< [Pa]
  std::vector<double> stress_bottom;     ///< [Pa]
  std::vector<double> weight_stress;     ///< of the grains [Pa]; empty where it is not known
  std::vector<double> unbalanced_ratio;  ///< mean unbalanced over mean contact force [-]
  std::string unbalanced_kind;  ///< of `solve`, that ended consolidation: "average" or "bearing"
  std::vector<double> inertial_number;  ///< [-]
  std::vector<double> energy_error;     ///< share of the work put in that is not found again [-]
};

/// One check: what was found, what is allowed, and whether it is a requirement of this test.
struct Check {
  std::string name;
  double found;      ///< [-]
  double allowed;    ///< [-]
  bool required;     ///< false: told for information
  bool made = true;  ///< false: something it takes is missing; the name says what
  bool passed() const { return made && found <= allowed; }
  bool missed() const { return made && !(found <= allowed); }
};

/// Largest share [-] by which the two platens' stresses differ, averaged over windows of
/// `check_averaging_width`, relative to the mean of both, at least to the confining stress. The
/// upper one's stress counts with the weight of the grains on it; where that is not known, alone.
double platen_difference(const ShearRecord& record);

/// The same at each sample, not averaged, signed: positive where the top carries more.
std::vector<double> platen_differences(const ShearRecord& record);

/// All checks of one test. The platens need not agree where a sleeve takes load
/// (`platens_must_agree` false). Throws InputError where the record is too short to check.
std::vector<Check> run_checks(const ShearRecord& record, bool platens_must_agree);

/// Heights [m] of the two platens.
struct PlatenHeights {
  double bottom, top;
};

/// Where the platens stand that began at 0 and `built` and were `first` apart before shear and
/// `now` after a part of it, all [m]. `moving` is the decks' variable: 0 the lower one moves, 1 the
/// upper one; with 2 the lower one moves before shear, and both by halves during it.
inline PlatenHeights platen_heights(double built, double first, double now, int moving)
{
  if (moving == 1) return {0.0, now};
  const double bottom = built - (moving == 0 ? now : 0.5 * (first + now));
  return {bottom, bottom + now};
}

/// The walls around grains: platens, and a cylinder about the z axis where there is one.
struct WallPlaces {
  PlatenHeights platens;
  std::optional<double> radius;  ///< [m]
};

/// Whether a grain whose center [m] this is has left through a wall. A grain on a wall overlaps it,
/// so that its surface sticks out; with its center beyond, nothing pushes it back.
inline bool is_outside(const std::array<double, 3>& center, const WallPlaces& walls)
{
  const auto& [x, y, z] = center;
  if (z < walls.platens.bottom || z > walls.platens.top) return true;
  return walls.radius && x * x + y * y > *walls.radius * *walls.radius;
}

/// Stress [Pa] of the weight of all grains on the cross section of a specimen, volume over height.
///
/// With grains of `density` [kg/m^3] whose volume is the share 1 - n of the specimen's,
///
///   W / A = density g (1 - n) V / (V / h) = density g (1 - n) h,
///
/// n the porosity [-] that counts overlaps twice, for the grains' mass does the same, and h the
/// height [m], both of one moment: the weight stays while the section grows.
inline double weight_stress(double density, double gravity, double porosity, double height)
{
  return density * gravity * (1.0 - porosity) * height;
}

}  // namespace encased_column
