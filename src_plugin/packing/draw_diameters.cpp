// SPDX-License-Identifier: GPL-2.0-only
#include "packing/draw_diameters.h"

#include "core/input_error.h"
#include "packing/grain_volume.h"
#include "packing/uniform_random.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace encased_column {

namespace {

// A mistake in units asks for a thousand million times the grains: no memory holds them.
constexpr double most_grains = 2e7;

double mean_grain_volume(const SizeClass& c, ClassDistribution distribution)
{
  const double m = number_exponent(distribution);
  return pi / 6.0 * power_integral(m + 3.0, c.diameter_low, c.diameter_high) /
         power_integral(m, c.diameter_low, c.diameter_high);
}

/// `diameters`, each moved by the fraction `t` of its distance towards `end`.
std::vector<double> moved(std::vector<double> diameters, double end, double t)
{
  for (double& d : diameters) d += t * (end - d);
  return diameters;
}

std::vector<double> moved_to_volume(const std::vector<double>& diameters, const SizeClass& c,
                                    double volume)
{
  const bool grow = volume_of(diameters) < volume;
  const double end = grow ? c.diameter_high : c.diameter_low;
  double low = 0.0;
  double high = 1.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    const bool short_of = (volume_of(moved(diameters, end, middle)) < volume) == grow;
    (short_of ? low : high) = middle;
  }
  return moved(diameters, end, 0.5 * (low + high));
}

std::vector<double> draw_class(const SizeClass& c, ClassDistribution distribution, double volume,
                               UniformRandom& random)
{
  const double most = std::floor(volume / grain_volume(c.diameter_low));
  const double least = std::ceil(volume / grain_volume(c.diameter_high));
  if (most < least || most < 1.0)
    throw InputError("the class " + in_words(c) + " holds " + in_words(volume) +
                     " m^3 of grains, which no whole number of its grains fills, enlarge the "
                     "specimen or join the class with its neighbour");
  const double count =
      std::clamp(std::round(volume / mean_grain_volume(c, distribution)), least, most);

  std::vector<double> diameters(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < diameters.size(); ++i)
    diameters[i] = power_quantile(number_exponent(distribution), c.diameter_low, c.diameter_high,
                                  (static_cast<double>(i) + random()) / count);
  return moved_to_volume(diameters, c, volume);
}

}  // namespace

double solid_volume(double porosity, double total_volume)
{
  // Above 0.7 grains do not touch and no specimen exists (loosest stable packings of equal
  // spheres: 0.45). The densest packings of 15:1 gradations without overlap lie near 0.22: at 0.1
  // the distance between centers is shortened by 1 - (0.78 / 0.90)^(1/3) = 5 % of a diameter, the
  // end of what a linear contact law of undeformed spheres can mean.
  if (!(porosity >= 0.1 && porosity <= 0.7))
    throw InputError("'porosity' must be between 0.1 and 0.7, found " + in_words(porosity) +
                     ", write for example 'porosity 0.2'");
  return (1.0 - porosity) * total_volume;
}

double expected_count(const Gradation& gradation, ClassDistribution distribution,
                      double solid_volume)
{
  double count = 0.0;
  for (const SizeClass& c : gradation)
    count += c.mass_percent / 100.0 * solid_volume / mean_grain_volume(c, distribution);
  return count;
}

std::vector<double> draw_diameters(const Gradation& gradation, ClassDistribution distribution,
                                   double solid_volume, std::uint64_t seed)
{
  const double expected = expected_count(gradation, distribution, solid_volume);
  if (!(expected <= most_grains))
    throw InputError("the gradation asks for " + in_words(expected) + " grains, more than " +
                     in_words(most_grains) +
                     ", leave out the finest with 'finest' or check the "
                     "unit of its diameters, which is m");
  double sum = 0.0;
  for (const SizeClass& c : gradation) sum += c.mass_percent;
  UniformRandom random(seed);
  std::vector<double> all;
  for (const SizeClass& c : gradation) {
    if (c.mass_percent == 0.0) continue;
    const std::vector<double> some =
        draw_class(c, distribution, c.mass_percent / sum * solid_volume, random);
    all.insert(all.end(), some.begin(), some.end());
  }
  std::sort(all.begin(), all.end(), std::greater<>());
  return all;
}

}  // namespace encased_column
