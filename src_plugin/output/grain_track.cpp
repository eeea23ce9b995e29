// SPDX-License-Identifier: GPL-2.0-only
#include "output/grain_track.h"

#include "measure/local_strain.h"

namespace encased_column {

void find_strains(std::vector<GrainRecord>& grains, double range, const PeriodicBox& box)
{
  std::vector<MovedGrain> moved;
  for (const GrainRecord& grain : grains) {
    const Vec3 displacement = as_vec3(grain.displacement.data());
    moved.push_back(
        {as_vec3(grain.position.data()) - displacement, displacement, 2.0 * grain.radius});
  }
  if (range < 0.0) range = usual_strain_range * mean_diameter_by_volume(moved);
  const std::vector<double> strain = local_deviatoric_strain(moved, range, box);
  for (std::size_t n = 0; n < grains.size(); ++n) grains[n].deviatoric_strain = strain[n];
}

}  // namespace encased_column
