#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace encased_column {

/// Grains between two sieves and their share of the mass.
struct SizeClass {
  double diameter_low;   ///< [m]
  double diameter_high;  ///< [m]
  double mass_percent;   ///< of all grains [%]
};

/// A table of size classes, from fine to coarse.
using Gradation = std::vector<SizeClass>;

/// How sizes spread inside a class. All three are a power of the diameter: their number density
/// goes with d^-4, d^-3 and d^0, and the mass passing with ln d, d and d^4.
enum class ClassDistribution {
  log_uniform,    ///< mass uniform in ln d: straight lines between sieves on the usual log axis
  uniform,        ///< mass uniform in d
  uniform_number  ///< number uniform in d: PFC's own draw between two radii
};

/// The distribution a deck names; throws InputError for any other word.
ClassDistribution class_distribution(const std::string& word);

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

/// Grains expected in `solid_volume` [m^3], from the mean grain volume of each class.
double expected_count(const Gradation& gradation, ClassDistribution distribution,
                      double solid_volume);

/// Diameters [m] of grains of `solid_volume` [m^3] in all, sorted from coarse to fine.
///
/// Each class gets the whole number of grains nearest to its volume over its mean grain volume,
/// with sizes drawn one from each of as many equally probable parts of the class. Then all sizes
/// of a class move a little towards one of its two ends, by one common fraction of their distance
/// to it, until its volume is exact: no grain leaves its class, as a scaling would let it. So the
/// mass of each class and the whole volume are met to round-off, for any seed.
/// Throws InputError when a class has less volume than a grain of it needs.
std::vector<double> draw_diameters(const Gradation& gradation, ClassDistribution distribution,
                                   double solid_volume, std::uint64_t seed);

/// Mass percent and number of given grains in each class, as sieving them would tell. A grain as
/// large as a sieve counts to the finer class.
struct ClassContent {
  double mass_percent;
  long count;
};
std::vector<ClassContent> sieve(const Gradation& gradation, const std::vector<double>& diameters);

/// Volume [m^3] of the grains that leave `porosity` [-] in `total_volume` [m^3].
/// Throws InputError unless the porosity is between 0.1 and 0.7.
double solid_volume(double porosity, double total_volume);

}  // namespace encased_column
