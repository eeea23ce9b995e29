// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/sleeve_record.h"

#include "analysis/sampled_curve.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace encased_column {

std::vector<SleeveProfile> profiles_of(const ProfileColumns& columns)
{
  std::map<double, SleeveProfile> by_step;
  for (std::size_t row = 0; row < columns.step.size(); ++row) {
    SleeveProfile& profile = by_step[columns.step[row]];
    if (row == 0 || columns.step[row] != columns.step[row - 1])
      profile = {columns.axial_strain[row], {}, {}};
    profile.height.push_back(columns.height[row]);
    profile.radial_displacement.push_back(columns.radial_displacement[row]);
  }
  std::vector<SleeveProfile> profiles;
  for (const auto& [step, profile] : by_step) profiles.push_back(profile);
  return profiles;
}

std::optional<SleeveProfile> profile_at(const std::vector<SleeveProfile>& profiles,
                                        double axial_strain)
{
  if (profiles.empty() || !got_to(profiles.back().axial_strain, axial_strain)) return std::nullopt;
  const auto after = std::find_if(profiles.begin(), profiles.end(), [&](const SleeveProfile& p) {
    return p.axial_strain >= axial_strain;
  });
  if (after == profiles.begin()) return profiles.front();
  if (after == profiles.end()) return profiles.back();
  const SleeveProfile &low = *(after - 1), &high = *after;
  const double share = (axial_strain - low.axial_strain) / (high.axial_strain - low.axial_strain);
  if (low.height.size() != high.height.size()) return share < 0.5 ? low : high;
  SleeveProfile profile{axial_strain, low.height, low.radial_displacement};
  for (std::size_t ring = 0; ring < low.height.size(); ++ring) {
    profile.height[ring] += share * (high.height[ring] - low.height[ring]);
    profile.radial_displacement[ring] +=
        share * (high.radial_displacement[ring] - low.radial_displacement[ring]);
  }
  return profile;
}

SleeveProfile between_platens(const SleeveProfile& profile, const PlatenHeights& platens)
{
  SleeveProfile inside{profile.axial_strain, {}, {}};
  for (std::size_t ring = 0; ring < profile.height.size(); ++ring)
    if (profile.height[ring] >= platens.bottom && profile.height[ring] <= platens.top) {
      inside.height.push_back(profile.height[ring]);
      inside.radial_displacement.push_back(profile.radial_displacement[ring]);
    }
  return inside;
}

std::vector<std::size_t> nearest_places(const std::vector<double>& strains,
                                        const std::vector<double>& wanted, double tolerance)
{
  std::vector<std::size_t> places;
  for (const double strain : wanted) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < strains.size(); ++i)
      if (std::abs(strains[i] - strain) < std::abs(strains[best] - strain)) best = i;
    if (strains.empty() || std::abs(strains[best] - strain) > tolerance) continue;
    if (places.empty() || places.back() != best) places.push_back(best);
  }
  return places;
}

std::vector<Check> sleeve_checks(const SleeveRecord& record, const StripLimit& limit)
{
  const auto largest = [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  };
  return {
      {"hoop tension of the sleeve, largest, within the study's strip test [kN/m]",
       largest(record.hoop_tension_max) / 1e3, limit.tension / 1e3, false},
      {"hoop strain of the sleeve, largest, within the study's strip test",
       largest(record.hoop_strain_max), limit.strain, false},
  };
}

}  // namespace encased_column
