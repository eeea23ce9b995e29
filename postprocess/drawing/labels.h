// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "drawing/figure.h"
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

/// "Dr = 40 % (n = 0.417)", of the laboratory's sample; the porosity at generation or the id of a
/// run that says less.
std::string density_label(const TestResult& test);

/// The tests' names in a legend, set by set, by what differs: of triaxial tests the confining
/// stress and, where two have the same, the relative density; of columns relative density,
/// gradation and confining stress. With "plain" or "encased" where both are drawn, and the run's
/// id where two runs would be called the same.
std::vector<std::vector<std::string>> test_labels(const std::vector<SetResult>& sets);

/// A number for each test, the same for the same confining stress, to color by; a further run of a
/// set at a stress already seen gets a new one.
std::vector<std::vector<std::size_t>> color_numbers(const std::vector<SetResult>& sets);

/// How curve `number` is drawn: the palette begins again behind its last color, with other strokes.
Stroke stroke_of_number(std::size_t number);

/// The same for a curve of `set`, one of `sets`: plain tests are dashed where there are others.
Stroke stroke_of(const SetResult& set, std::size_t sets, std::size_t number);

/// Axial strains [-] at which a test is looked at along its height: each 5 % of a triaxial test,
/// each 6 mm of a column, for the study looks at its columns at 12 and 24 mm. The first is 0.
std::vector<double> shown_strains(const TestResult& test);

/// Half of the step between them [-]: how far a sample may lie off.
double shown_tolerance(const TestResult& test);

}  // namespace encased_column
