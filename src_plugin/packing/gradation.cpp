#include "packing/gradation.h"

#include "core/constants.h"
#include "core/input_error.h"
#include "packing/grain_volume.h"
#include "packing/uniform_random.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace encased_column {

namespace {

/// The number density of a distribution goes with d to this power.
double number_exponent(ClassDistribution distribution)
{
  switch (distribution) {
    case ClassDistribution::log_uniform:
      return -4.0;
    case ClassDistribution::uniform:
      return -3.0;
    case ClassDistribution::uniform_number:
      break;
  }
  return 0.0;
}

/// Integral of x^m from `a` to `b`, both larger than zero.
double power_integral(double m, double a, double b)
{
  if (m == -1.0) return std::log(b / a);
  return (std::pow(b, m + 1.0) - std::pow(a, m + 1.0)) / (m + 1.0);
}

/// The d that splits the integral of x^m from `a` to `b` at the fraction `f`.
double power_quantile(double m, double a, double b, double f)
{
  if (m == -1.0) return a * std::pow(b / a, f);
  const double low = std::pow(a, m + 1.0);
  const double high = std::pow(b, m + 1.0);
  return std::clamp(std::pow(low + f * (high - low), 1.0 / (m + 1.0)), a, b);
}

double mean_grain_volume(const SizeClass& c, ClassDistribution distribution)
{
  const double m = number_exponent(distribution);
  return pi / 6.0 * power_integral(m + 3.0, c.diameter_low, c.diameter_high) /
         power_integral(m, c.diameter_low, c.diameter_high);
}

std::string in_words(const SizeClass& c)
{
  return encased_column::in_words(c.diameter_low) + " to " +
         encased_column::in_words(c.diameter_high) + " m";
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
    throw InputError("the class " + in_words(c) + " holds " + encased_column::in_words(volume) +
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

ClassDistribution class_distribution(const std::string& word)
{
  if (word == "log_uniform") return ClassDistribution::log_uniform;
  if (word == "uniform") return ClassDistribution::uniform;
  if (word == "uniform_number") return ClassDistribution::uniform_number;
  throw InputError("'distribution' must be one of: log_uniform, uniform, uniform_number; found '" +
                   word + "'");
}

void check_gradation(const Gradation& gradation)
{
  if (gradation.empty())
    throw InputError(
        "a gradation needs at least one class, write 'diameter_low,diameter_high,"
        "mass_percent' per line");
  double sum = 0.0;
  double below = 0.0;
  for (const SizeClass& c : gradation) {
    if (!(c.diameter_low > 0.0))
      throw InputError("diameters of a gradation must be larger than zero, found " +
                       encased_column::in_words(c.diameter_low) + " m, write them in meters");
    if (!(c.diameter_high > c.diameter_low))
      throw InputError("the class " + in_words(c) +
                       " is reversed, write the smaller diameter first");
    if (!(c.diameter_low >= below))
      throw InputError("the class " + in_words(c) + " starts below the end of the one before, " +
                       encased_column::in_words(below) +
                       " m, write classes from fine to coarse without overlap");
    if (!(c.mass_percent >= 0.0))
      throw InputError("the class " + in_words(c) + " has " +
                       encased_column::in_words(c.mass_percent) +
                       " % of the mass, write a percent of zero or more");
    sum += c.mass_percent;
    below = c.diameter_high;
  }
  if (!(std::abs(sum - 100.0) <= 0.01))
    throw InputError("the mass percents of a gradation must sum to 100, found " +
                     encased_column::in_words(sum) + ", correct the percents");
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
    throw InputError("'finest' must leave some grains, found " + encased_column::in_words(finest) +
                     " m, the coarsest are " +
                     encased_column::in_words(gradation.back().diameter_high) +
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

}  // namespace encased_column
