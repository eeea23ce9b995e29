// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "analysis/run_checks.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace encased_column {

/// What a sleeve said while its specimen was sheared; all samples, in order.
struct SleeveRecord {
  std::vector<double> axial_strain;       ///< of the specimen [-]
  std::vector<double> hoop_tension_mean;  ///< weighted by area between the platens [N/m]
  std::vector<double> hoop_tension_max;   ///< of a facet [N/m]
  std::vector<double> hoop_strain_mean;   ///< stretch positive [-]
  std::vector<double> hoop_strain_max;    ///< of a facet [-]
  std::vector<double> friction_force;     ///< grains lay on the sleeve along its axis [N]
  std::vector<double> enclosed_volume;    ///< between the platens [m^3]
};

/// How far a strip of the material was pulled in the laboratory.
struct StripLimit {
  double tension;  ///< [N/m]
  double strain;   ///< [-]
};

/// The largest hoop tension and strain beside those of the strip test, for information: beyond
/// them the linear law of the sleeve is no longer measured.
std::vector<Check> sleeve_checks(const SleeveRecord& record, const StripLimit& limit);

/// The sleeve along its height at one time, ring by ring from the bottom.
struct SleeveProfile {
  double axial_strain;                      ///< of the specimen [-]
  std::vector<double> height;               ///< z of the rings [m]
  std::vector<double> radial_displacement;  ///< expansion positive [m]
};

/// The columns of a file that lists one profile after the other.
struct ProfileColumns {
  std::vector<double> step, axial_strain, height, radial_displacement;
};

/// The profiles of `columns`, in order: rows of one step that follow one another make one. Of a
/// step that comes twice, as after a restart, the later one counts.
std::vector<SleeveProfile> profiles_of(const ProfileColumns& columns);

/// The sleeve at `axial_strain`, each ring straight between the profiles before and after it.
/// Nothing beyond the last one, but for half a percent of its strain; the first one before it.
std::optional<SleeveProfile> profile_at(const std::vector<SleeveProfile>& profiles,
                                        double axial_strain);

/// The rings of `profile` that stand between the platens: a platen may move inside a sleeve that is
/// longer than the specimen.
SleeveProfile between_platens(const SleeveProfile& profile, const PlatenHeights& platens);

/// For each strain of `wanted` (rising) the place in `strains` of the nearest one, if it is not
/// farther than `tolerance`; none twice.
std::vector<std::size_t> nearest_places(const std::vector<double>& strains,
                                        const std::vector<double>& wanted, double tolerance);

}  // namespace encased_column
