// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "packing/gradation.h"

#include <cstdint>
#include <vector>

namespace encased_column {

/// Volume [m^3] of the grains that leave `porosity` [-] in `total_volume` [m^3].
/// Throws InputError unless the porosity is between 0.1 and 0.7.
double solid_volume(double porosity, double total_volume);

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
/// Throws InputError when a class has less volume than a grain of it needs, and beyond 2e7 grains.
std::vector<double> draw_diameters(const Gradation& gradation, ClassDistribution distribution,
                                   double solid_volume, std::uint64_t seed);

}  // namespace encased_column
