#include "tables/sleeve_theory.h"

#include "analysis/encasement.h"
#include "files/column_names.h"

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
  const auto found = run.variables.find("radius");
  return found != run.variables.end() ? found->second
                                      : run.history.numbers(history_column::radius).front();
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

}  // namespace encased_column
