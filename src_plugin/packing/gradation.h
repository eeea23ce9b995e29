// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "packing/class_distribution.h"

#include <string>
#include <vector>

namespace encased_column {

/// Grains between two sieves and their share of the mass.
struct SizeClass {
  double diameter_low;   ///< [m]
  double diameter_high;  ///< [m]
  double mass_percent;   ///< of all grains [%]
};

/// The class as a user would write it: "0.001 to 0.002 m".
std::string in_words(const SizeClass& size_class);

/// A table of size classes, from fine to coarse.
using Gradation = std::vector<SizeClass>;

/// Throws InputError unless the classes are positive, not reversed, from fine to coarse without
/// overlap, and their percents not negative and 100 in sum (within 0.01).
void check_gradation(const Gradation& gradation);

/// The gradation without grains smaller than `finest` [m]; what stays is 100 % again. A class that
/// `finest` cuts keeps its coarser part. Throws InputError when nothing is left.
Gradation without_finer(const Gradation& gradation, ClassDistribution distribution, double finest);

/// Diameter [m] below which `percent` of the mass lies, of the classes themselves.
double passing_diameter(const Gradation& gradation, ClassDistribution distribution, double percent);

/// The same of given grains: diameter of the grain with which the mass reaches `percent`.
/// Requires `diameters` [m] sorted from coarse to fine.
double passing_diameter(const std::vector<double>& diameters, double percent);

/// The sizes that describe a gradation curve, and the two coefficients made of them.
struct CharacteristicSizes {
  double d10, d30, d60;                                         ///< [m]
  double uniformity() const { return d60 / d10; }               ///< C_u [-]
  double curvature() const { return d30 * d30 / (d10 * d60); }  ///< C_c [-]
};
CharacteristicSizes characteristic_sizes(const Gradation& gradation,
                                         ClassDistribution distribution);
CharacteristicSizes characteristic_sizes(const std::vector<double>& diameters);

/// Mass percent and number of given grains in each class, as sieving them would tell. A grain as
/// large as a sieve counts to the finer class.
struct ClassContent {
  double mass_percent;
  long count;
};
std::vector<ClassContent> sieve(const Gradation& gradation, const std::vector<double>& diameters);

}  // namespace encased_column
