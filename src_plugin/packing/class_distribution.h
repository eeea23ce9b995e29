// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>

namespace encased_column {

/// How sizes spread inside a class. All three are a power of the diameter: their number density
/// goes with d^-4, d^-3 and d^0, and the mass passing with ln d, d and d^4.
enum class ClassDistribution {
  log_uniform,    ///< mass uniform in ln d: straight lines between sieves on the usual log axis
  uniform,        ///< mass uniform in d
  uniform_number  ///< number uniform in d: PFC's own draw between two radii
};

/// The distribution a deck names; throws InputError for any other word.
ClassDistribution class_distribution(const std::string& word);

/// The number of grains per diameter d goes with d to this power.
double number_exponent(ClassDistribution distribution);

/// Integral of x^m from `a` to `b`, both larger than zero.
double power_integral(double m, double a, double b);

/// The x that splits the integral of x^m from `a` to `b` at the fraction `f` of it.
double power_quantile(double m, double a, double b, double f);

}  // namespace encased_column
