#pragma once

#include "tables/evaluation.h"

#include <string>
#include <vector>

namespace encased_column {

/// "axial strain ε₁ [%]", the x axis of most figures.
extern const char* const axial_strain_title;

/// 100 times each value: strains are stored as shares and shown in percent.
std::vector<double> percent(const std::vector<double>& shares);

/// Each value times `factor`.
std::vector<double> scaled(const std::vector<double>& values, double factor);

/// The tests' names in a legend, set by set: the confining stress, with "plain" or "encased" where
/// both are drawn, and with the run's id where two runs would be called the same.
std::vector<std::vector<std::string>> test_labels(const std::vector<SetResult>& sets);

/// A number for each test, the same for the same confining stress, to color by; a further run of a
/// set at a stress already seen gets a new one.
std::vector<std::vector<std::size_t>> color_numbers(const std::vector<SetResult>& sets);

}  // namespace encased_column
