// SPDX-License-Identifier: GPL-2.0-only
#include "runs/run_formula.h"

#include "core/constants.h"

#include <cmath>
#include <random>

namespace encased_column {

namespace {

/// Normally distributed, the same on every machine (Box and Muller).
double normal(std::mt19937& random)
{
  const double a = (static_cast<double>(random()) + 1.0) / 4294967297.0;
  const double b = static_cast<double>(random()) / 4294967296.0;
  return std::sqrt(-2.0 * std::log(a)) * std::cos(2.0 * pi * b);
}

class FormulaProgram : public RunProgram {
 public:
  RunsEnd make(const std::vector<PlannedRun>& runs, const Tell& tell) override
  {
    for (const PlannedRun& run : runs) tell(run, run_formula(run));
    return RunsEnd::made;
  }
};

}  // namespace

RunResult run_formula(const PlannedRun& run)
{
  const double modulus = run.number("modulus", 100e6), kappa = run.number("kappa", 2.0),
               mu = run.number("mu", 0.5), mu_r = run.number("mu_r", 0.0),
               sigma3 = run.number("sigma3", 100e3);
  std::mt19937 random(
      static_cast<unsigned>(std::lround(1e4 * run.number("seed", 1.0) + sigma3 / 1e3)));
  const double stiffness_scatter = 1.0 + 0.02 * normal(random),
               strength_scatter = 1.0 + 0.01 * normal(random);
  const double secant =
      0.08 * modulus * std::pow(sigma3 / 100e3, 0.4) / (0.85 + 0.15 * kappa) * stiffness_scatter;
  const double angle =
      (18.0 + 20.0 * (1.0 - std::exp(-2.5 * mu)) + 6.0 * mu_r / (0.3 + mu_r)) * pi / 180.0;
  const double ratio = (1.0 + std::sin(angle)) / (1.0 - std::sin(angle));
  const double peak = sigma3 * (ratio - 1.0) * strength_scatter;
  const double end = 1.0 - 0.35 * std::exp(-4.0 * mu_r) * (0.4 + mu);
  constexpr double peak_strain = 0.10, end_strain = 0.20;
  const double half_strain = 0.5 * peak / secant;
  const double top = 1.0 - std::exp2(-peak_strain / half_strain);
  std::vector<double> strain, stress;
  for (int n = 0; n <= 400; ++n) {
    strain.push_back(end_strain * n / 400.0);
    const double fall = std::max(strain.back() - peak_strain, 0.0) / (end_strain - peak_strain);
    const double rise =
        strain.back() < peak_strain ? (1.0 - std::exp2(-strain.back() / half_strain)) / top : 1.0;
    stress.push_back(peak * rise * (1.0 - fall * (1.0 - end)));
  }
  RunResult result = result_of_curve(strain, stress, sigma3);
  result.seconds = 0.01 * std::sqrt(modulus / 1e6);  // stiffer grains take more steps
  return result;
}

std::unique_ptr<RunProgram> formula_program()
{
  return std::make_unique<FormulaProgram>();
}

}  // namespace encased_column
