// SPDX-License-Identifier: GPL-2.0-only
#include "packing/gradation.h"

#include "core/input_error.h"
#include "packing/grain_volume.h"

#include <cmath>

namespace encased_column {

std::string in_words(const SizeClass& size_class)
{
  return in_words(size_class.diameter_low) + " to " + in_words(size_class.diameter_high) + " m";
}

void check_gradation(const Gradation& gradation)
{
  if (gradation.empty())
    throw InputError(
        "a gradation needs at least one class, found none, write 'diameter_low,diameter_high,"
        "mass_percent' per line");
  double sum = 0.0;
  double below = 0.0;
  for (const SizeClass& c : gradation) {
    if (!(c.diameter_low > 0.0))
      throw InputError("diameters of a gradation must be larger than zero, found " +
                       in_words(c.diameter_low) + " m, write them in meters");
    if (!(c.diameter_high > c.diameter_low))
      throw InputError("the class " + in_words(c) +
                       " is reversed, write the smaller diameter first");
    if (!(c.diameter_low >= below))
      throw InputError("the class " + in_words(c) + " starts below the end of the one before, " +
                       in_words(below) + " m, write classes from fine to coarse without overlap");
    if (!(c.mass_percent >= 0.0))
      throw InputError("the class " + in_words(c) + " has " + in_words(c.mass_percent) +
                       " % of the mass, write a percent of zero or more");
    sum += c.mass_percent;
    below = c.diameter_high;
  }
  // Thirds rounded to two decimals miss by 0.01, and by the round-off of their sum.
  if (!(std::abs(sum - 100.0) <= 0.01 + 1e-9))
    throw InputError("the mass percents of a gradation must sum to 100, found " + in_words(sum) +
                     ", correct the percents");
}

Gradation without_finer(const Gradation& gradation, ClassDistribution distribution, double finest)
{
  const double m = number_exponent(distribution) + 3.0;
  Gradation rest;
  double sum = 0.0;
  for (SizeClass c : gradation) {
    if (c.diameter_high <= finest) continue;
    if (c.diameter_low < finest) {
      c.mass_percent *= power_integral(m, finest, c.diameter_high) /
                        power_integral(m, c.diameter_low, c.diameter_high);
      c.diameter_low = finest;
    }
    sum += c.mass_percent;
    rest.push_back(c);
  }
  if (!(sum > 0.0))
    throw InputError("'finest' must leave some grains, found " + in_words(finest) +
                     " m, the coarsest are " + in_words(gradation.back().diameter_high) +
                     " m, write a smaller diameter");
  for (SizeClass& c : rest) c.mass_percent *= 100.0 / sum;
  return rest;
}

double passing_diameter(const Gradation& gradation, ClassDistribution distribution, double percent)
{
  double below = 0.0;
  for (const SizeClass& c : gradation) {
    if (c.mass_percent > 0.0 && percent <= below + c.mass_percent)
      return power_quantile(number_exponent(distribution) + 3.0, c.diameter_low, c.diameter_high,
                            (percent - below) / c.mass_percent);
    below += c.mass_percent;
  }
  return gradation.back().diameter_high;
}

double passing_diameter(const std::vector<double>& diameters, double percent)
{
  const double wanted = percent / 100.0 * volume_of(diameters);
  double below = 0.0;
  for (auto d = diameters.rbegin(); d != diameters.rend(); ++d) {
    below += grain_volume(*d);
    if (below >= wanted) return *d;
  }
  return diameters.front();
}

CharacteristicSizes characteristic_sizes(const Gradation& gradation, ClassDistribution distribution)
{
  return {passing_diameter(gradation, distribution, 10.0),
          passing_diameter(gradation, distribution, 30.0),
          passing_diameter(gradation, distribution, 60.0)};
}

CharacteristicSizes characteristic_sizes(const std::vector<double>& diameters)
{
  return {passing_diameter(diameters, 10.0), passing_diameter(diameters, 30.0),
          passing_diameter(diameters, 60.0)};
}

std::vector<ClassContent> sieve(const Gradation& gradation, const std::vector<double>& diameters)
{
  std::vector<ClassContent> contents(gradation.size(), {0.0, 0});
  const double all = volume_of(diameters);
  for (double d : diameters)
    for (std::size_t k = 0; k < gradation.size(); ++k)
      if (d <= gradation[k].diameter_high) {
        contents[k].mass_percent += 100.0 * grain_volume(d) / all;
        ++contents[k].count;
        break;
      }
  return contents;
}

}  // namespace encased_column
