#pragma once

#include <cstddef>
#include <vector>

namespace encased_column {

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

/// For each strain of `wanted` (rising) the place in `strains` of the nearest one, if it is not
/// farther than `tolerance`; none twice.
std::vector<std::size_t> nearest_places(const std::vector<double>& strains,
                                        const std::vector<double>& wanted, double tolerance);

}  // namespace encased_column
