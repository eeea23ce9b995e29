// SPDX-License-Identifier: GPL-2.0-only
#include "tables/theory_table.h"

#include "analysis/encasement.h"
#include "core/constants.h"
#include "files/column_names.h"
#include "tables/text_layout.h"

#include <cmath>

namespace encased_column {

namespace {

const ColumnName core_axial = history_column::core_axial_stress,
                 core_radial = history_column::core_radial_stress;
constexpr double reached_within = 1e-3;  // of axial strain: a last sample may miss the round number

bool reaches(const std::vector<double>& strains, double strain)
{
  return strains.front() < strain + reached_within && strains.back() > strain - reached_within;
}

double mean_at(double strain, const std::vector<double>& strains, const std::vector<double>& values)
{
  const double half_width = 0.5 * peak_averaging_width;
  return SampledCurve(strains, values).mean(strain - half_width, strain + half_width);
}

/// Radius [m] of the sleeve free of stress; where the deck does not say, that at the start of
/// shear.
double initial_radius(const CaseRun& run)
{
  const std::optional<double> radius = run.number("radius");
  return radius ? *radius : run.history.numbers(history_column::radius).front();
}

/// The angle of friction [rad] that the grains of the middle third mobilise, where the history has
/// their stress.
std::optional<double> mobilised_angle(const TestResult& test, double strain)
{
  const TextTable& history = test.run->history;
  if (!history.has(core_axial) || !history.has(core_radial)) return std::nullopt;
  const double axial = mean_at(strain, test.axial_strain, history.numbers(core_axial));
  const double radial = mean_at(strain, test.axial_strain, history.numbers(core_radial));
  return std::asin(mobilised_sine(axial - radial, radial));
}

}  // namespace

std::optional<SleeveState> sleeve_state(const TestResult& test, double axial_strain)
{
  if (!test.sleeve || !reaches(test.axial_strain, axial_strain) ||
      !reaches(test.sleeve->axial_strain, axial_strain))
    return std::nullopt;
  const auto at_platens = [&](const std::vector<double>& values) {
    return mean_at(axial_strain, test.axial_strain, values);
  };
  const auto at_sleeve = [&](const std::vector<double>& values) {
    return mean_at(axial_strain, test.sleeve->axial_strain, values);
  };
  const double sigma3 = at_platens(test.record.confining_stress);
  const double top = at_platens(test.record.stress_top);
  const double bottom = at_platens(test.record.stress_bottom);
  const double area = at_sleeve(test.sleeve->enclosed_volume) /
                      at_platens(test.run->history.numbers(history_column::height));
  const double tension = at_sleeve(test.sleeve->hoop_tension_mean);
  const double radius =
      stretched_radius(initial_radius(*test.run), at_sleeve(test.sleeve->hoop_strain_mean));

  SleeveState state{axial_strain,
                    top - sigma3,
                    bottom - sigma3,
                    tension,
                    radius,
                    confinement_of_ring(tension, radius),
                    friction_share(at_sleeve(test.sleeve->friction_force), top, bottom, area),
                    mobilised_angle(test, axial_strain),
                    std::nullopt};
  if (state.friction_angle)
    state.q_theory = encased_deviatoric_stress(passive_coefficient(std::sin(*state.friction_angle)),
                                               sigma3, state.extra_confinement);
  return state;
}

namespace {

std::string difference(double value, double theory)
{
  const double percent = 100.0 * (value / theory - 1.0);
  return (percent >= 0.0 ? "+" : "") + fixed(percent, 1);
}

std::vector<std::string> as_words(const std::string& id, const SleeveState& state)
{
  const auto kilo = [](double value, int decimals) { return fixed(value / 1e3, decimals); };
  std::vector<std::string> words{id,
                                 fixed(100.0 * state.axial_strain, 0),
                                 kilo(state.hoop_tension, 3),
                                 fixed(1e3 * state.radius, 2),
                                 kilo(state.extra_confinement, 1),
                                 "-",
                                 "-",
                                 kilo(state.q_top, 1),
                                 "-",
                                 kilo(state.q_bottom, 1),
                                 "-",
                                 fixed(100.0 * state.friction_share, 1)};
  if (state.q_theory) {
    words[5] = fixed(*state.friction_angle * 180.0 / pi, 2);
    words[6] = kilo(*state.q_theory, 1);
    words[8] = difference(state.q_top, *state.q_theory);
    words[10] = difference(state.q_bottom, *state.q_theory);
  }
  return words;
}

const std::vector<std::string> headings{
    "test",           "axial strain [%]",     "T [kN/m]",
    "r [mm]",         "dsigma3 [kPa]",        "phi [deg]",
    "q theory [kPa]", "q top [kPa]",          "top to theory [%]",
    "q bottom [kPa]", "bottom to theory [%]", "friction share [%]"};

}  // namespace

Rows theory_rows(const std::vector<SetResult>& sets)
{
  Rows rows{headings};
  for (const SetResult& set : sets)
    for (const TestResult& test : set.tests)
      for (const double strain : {0.05, 0.10, 0.15, 0.20})
        if (const auto state = sleeve_state(test, strain))
          rows.push_back(as_words(test.run->id, *state));
  return rows;
}

std::string theory_text(const std::vector<SetResult>& sets)
{
  const Rows rows = theory_rows(sets);
  if (rows.size() == 1) return {};
  std::vector<bool> right(headings.size(), true);
  right.front() = false;
  return "\nEncased tests beside q = Kp (sigma3 + dsigma3) - sigma3, dsigma3 = T / r\n\n" +
         aligned(rows, right) +
         "T: mean hoop tension; r: radius from the mean hoop strain; phi: mobilised by the "
         "grains of the middle third;\nfriction share: of the larger platen force, taken by the "
         "sleeve "
         "along its axis.\n";
}

std::string theory_csv(const std::vector<SetResult>& sets)
{
  Rows rows = theory_rows(sets);
  if (rows.size() == 1) return {};
  for (std::vector<std::string>& row : rows)
    for (std::string& word : row)
      if (word == "-") word.clear();
  return comma_separated(rows);
}

}  // namespace encased_column
