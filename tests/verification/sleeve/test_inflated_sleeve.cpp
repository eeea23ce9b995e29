// SPDX-License-Identifier: GPL-2.0-only
// An empty sleeve under pressure from inside, through the deck, against D w'''' + E t w / R^2 = p.
#include "support/child_program.h"
#include "support/csv_table.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

using namespace encased_column::testing;

namespace {

constexpr double radius = 0.05, length = 0.12, thickness = 0.01, encasement_stiffness = 115e3;
constexpr double pressure =
    50.0;  // a thousandth of a usual one: the closed form is for small strain

/// w / w0 at x from mid height; source and tabulated values: tests/verification/shell.
struct Profile {
  double beta, a, even, odd;

  explicit Profile(double poisson)
  {
    beta = std::pow(3.0 * (1.0 - poisson * poisson), 0.25) / std::sqrt(radius * thickness);
    a = 0.5 * beta * length;
    const double s = std::sinh(2.0 * a) + std::sin(2.0 * a);
    even = -2.0 * (std::cos(a) * std::sinh(a) + std::sin(a) * std::cosh(a)) / s;
    odd = -2.0 * (std::sin(a) * std::cosh(a) - std::cos(a) * std::sinh(a)) / s;
  }
  double at(double x) const
  {
    return 1.0 + even * std::cos(beta * x) * std::cosh(beta * x) +
           odd * std::sin(beta * x) * std::sinh(beta * x);
  }
  double mean() const
  {
    double sum = 0.0;
    for (int n = 0; n < 1000; ++n) sum += at(length * ((n + 0.5) / 1000.0 - 0.5)) / 1000.0;
    return sum;
  }
};

/// Radial displacement [m], around a grain that touches nothing, of the clamped sleeve at 10, 20
/// and 30 mm over its lower end.
std::array<double, 3> displacements(double poisson)
{
  const TemporaryFolder folder;
  const Outcome outcome = run_deck(
      opening_deck("empty_cylinder") +
          "create_atoms 1 single 0 0 0.02 units box\nset group all diameter 0.02 density 2500\n"
          "fix side all mesh/surface/shell cylinder 0.05 0 0.12 edge 0.005 type 2 platens top "
          "bottom modulus 11.5e6 thickness 0.01 density 30 top_end clamped bottom_end clamped "
          "pressed everywhere poisson " +
          std::to_string(poisson) +
          "\nfix top all servo/platen position top z 0.04 side side type 2\n"
          "fix bottom all servo/platen position bottom z 0 side side type 2\n"
          "fix move all motion step 1.0\n"
          "fix history all specimen/history platens top bottom side side motion move every 500\n"
          "run 0\nfix_modify side pressure -50\nrun 3000\n",
      1, folder.path());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  const CsvTable history(folder.path() / "history.csv");
  std::array<double, 3> w{};
  const char* names[] = {"radial_strain_25 [-]", "radial_strain_50 [-]", "radial_strain_75 [-]"};
  for (int n = 0; n < 3; ++n) {
    const std::vector<double> strain = history.column(names[n]);
    EXPECT_NEAR(strain.back(), strain[strain.size() - 2], 3e-3 * std::abs(strain.back()))
        << "it has come to rest";
    w[n] = -radius * strain.back();
  }
  return w;
}

void expect_within_one_percent(const std::array<double, 3>& w, const Profile& profile, double w0)
{
  for (int n = 0; n < 3; ++n) {
    const double expected = profile.at(0.5 * length - 0.01 * (n + 1));
    std::printf("clamped sleeve at %d mm: w / w0 %.4f, closed form %.4f\n", 10 * (n + 1), w[n] / w0,
                expected);
    EXPECT_NEAR(w[n] / w0, expected, 0.01);
  }
}

}  // namespace

// Without Poisson's ratio it does not matter that the ends cannot move along the axis.
TEST(InflatedSleeve, ClampedEndsGiveTheClosedFormWithinOnePercentAtFiveMillimetreFacets)
{
  expect_within_one_percent(displacements(0.0), Profile(0.0),
                            pressure * radius * radius / encasement_stiffness);
}

// Ends that stay apart bring an axial tension N = E t nu m w0' / ((1 - nu^2) R), m the mean of the
// profile, which bears N nu / R of the pressure: w0' = w0 / (1 + m nu^2 / (1 - nu^2)).
TEST(InflatedSleeve, ClampedEndsWithPoissonsRatioBearPartOfThePressureByAxialTension)
{
  const double poisson = 0.3;
  const Profile profile(poisson);
  const double w0 = pressure * radius * radius / encasement_stiffness;
  expect_within_one_percent(
      displacements(poisson), profile,
      w0 / (1.0 + profile.mean() * poisson * poisson / (1.0 - poisson * poisson)));
}
