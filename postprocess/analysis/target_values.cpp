// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/target_values.h"

#include "analysis/sampled_curve.h"

#include <algorithm>

namespace encased_column {

namespace {

using Found = std::optional<double>;
using Test = TargetRecord;
using Condition = TargetCondition;

constexpr double last_stretch = 1e-3;  // m

std::size_t largest_place(const std::vector<double>& values)
{
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

/// What the record holds as it is.
template <std::optional<double> Test::*number>
Found number_of(const Test& test, const Condition&)
{
  return test.*number;
}

/// At 0.25, 0.5 or 0.75 H.
template <std::size_t place>
Found expansion_at_the_end(const Test& test, const Condition&)
{
  if (test.expansion_at_the_end.size() <= place) return std::nullopt;
  return test.expansion_at_the_end[place];
}

/// What of `profile` stands between the platens; nothing where it holds no ring there.
std::optional<SleeveProfile> inside(const Test& test, const std::optional<SleeveProfile>& profile)
{
  if (!profile) return std::nullopt;
  const SleeveProfile part = between_platens(*profile, test.shape.platens(profile->axial_strain));
  return part.height.empty() ? std::nullopt : std::optional(part);
}

std::optional<SleeveProfile> last_profile(const Test& test)
{
  if (test.profiles.empty()) return std::nullopt;
  return inside(test, test.profiles.back());
}

/// How far [diameters] `height` [m] lies below the upper platen.
double depth(const Test& test, const SleeveProfile& profile, double height)
{
  return (test.shape.platens(profile.axial_strain).top - height) / test.shape.diameter;
}

/// The smallest and the largest porosity of the spheres at the start.
std::optional<std::pair<double, double>> porosities(const Test& test)
{
  if (test.spheres.empty() || test.spheres.front().empty()) return std::nullopt;
  const auto values = along_column(test.spheres, 0, &SphereSample::porosity_less_overlap);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return std::pair(*low, *high);
}

}  // namespace

Found pressure_at(const Test& test, const Condition& condition)
{
  if (!condition.displacement || test.displacement.size() < 2 ||
      !got_to(test.displacement.back(), *condition.displacement))
    return std::nullopt;
  return SampledCurve(test.displacement, test.pressure).value(*condition.displacement);
}

Found pressure_at_the_end(const Test& test, const Condition&)
{
  if (test.displacement.size() < 2) return std::nullopt;
  const double end = test.displacement.back();
  return SampledCurve(test.displacement, test.pressure).mean(end - last_stretch, end);
}

Found depth_of_peak_expansion(const Test& test, const Condition&)
{
  const std::optional<SleeveProfile> last = last_profile(test);
  if (!last) return std::nullopt;
  return depth(test, *last, last->height[largest_place(last->radial_displacement)]);
}

Found depth_of_expansion(const Test& test, const Condition&)
{
  const std::optional<SleeveProfile> last = last_profile(test);
  if (!last) return std::nullopt;
  const std::vector<double>&height = last->height, &expansion = last->radial_displacement;
  std::size_t at = largest_place(expansion);
  const double half = 0.5 * expansion[at];
  while (at > 0 && expansion[at - 1] > half) --at;
  double end = height[at];
  if (at > 0) {
    const double share = (expansion[at] - half) / (expansion[at] - expansion[at - 1]);
    end += share * (height[at - 1] - height[at]);
  }
  return depth(test, *last, end);
}

Found largest_expansion(const Test& test, const Condition& condition)
{
  if (!condition.displacement) return std::nullopt;
  const std::optional<SleeveProfile> then =
      inside(test, profile_at(test.profiles, *condition.displacement / test.shape.height));
  if (!then) return std::nullopt;
  return then->radial_displacement[largest_place(then->radial_displacement)];
}

Found force_before(const Test& test, const Condition&)
{
  if (test.contacts.empty()) return std::nullopt;
  return test.contacts.front().largest_force;
}

Found force_after(const Test& test, const Condition&)
{
  if (test.contacts.size() < 2) return std::nullopt;
  return test.contacts.back().largest_force;
}

Found lowest_porosity(const Test& test, const Condition&)
{
  const auto found = porosities(test);
  return found ? Found(found->first) : std::nullopt;
}

Found highest_porosity(const Test& test, const Condition&)
{
  const auto found = porosities(test);
  return found ? Found(found->second) : std::nullopt;
}

Found mean_coordination(const Test& test, const Condition&)
{
  if (test.spheres.empty() || test.spheres.front().empty()) return std::nullopt;
  return mean_of_spheres(test.spheres, 0, &SphereSample::coordination_number);
}

Found strip_tension(const Test& test, const Condition& condition)
{
  if (!condition.elongation || test.strip_strain.size() < 2 ||
      test.strip_strain.back() < *condition.elongation - 1e-9)
    return std::nullopt;
  return SampledCurve(test.strip_strain, test.strip_tension).value(*condition.elongation);
}

const std::vector<TargetValue>& target_values()
{
  static const std::vector<TargetValue> values{
      {"secant modulus E50", "", number_of<&Test::secant_modulus>},
      {"apparent friction angle", "", number_of<&Test::friction_angle>},
      {"apparent cohesion", "", number_of<&Test::cohesion>},
      {"peak deviator q", "", number_of<&Test::peak>},
      {"porosity at generation", "", number_of<&Test::generation_porosity>},
      {"porosity", "", number_of<&Test::porosity>},
      {"number of particles", "", number_of<&Test::grains>},
      {"radial strain at 0.25H", "", expansion_at_the_end<0>},
      {"radial strain at 0.50H", "", expansion_at_the_end<1>},
      {"radial strain at 0.75H", "", expansion_at_the_end<2>},
      {"tensile force per width", "", strip_tension},
      {"vertical pressure", "", pressure_at},
      {"bearing capacity", "", pressure_at_the_end},
      {"height of peak expansion below the top", "", depth_of_peak_expansion},
      {"depth within which expansion is confined", "", depth_of_expansion},
      {"depth of the pronounced expansion below the top", "", depth_of_peak_expansion},
      {"largest contact force before loading", "", force_before},
      {"largest contact force after loading", "", force_after},
      {"initial porosity in measuring spheres", "lowest", lowest_porosity},
      {"initial porosity in measuring spheres", "highest", highest_porosity},
      {"initial coordination number", "", mean_coordination},
      {"maximum radial expansion", "", largest_expansion},
  };
  return values;
}

}  // namespace encased_column
