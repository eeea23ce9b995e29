// The energy of grains and sleeve together, through the deck.
#include "restart/encased_deck.h"
#include "support/csv_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

using namespace encased_column::testing;

namespace {

/// Energy [J] that the specimen has, less what came in, plus what was lost, row by row.
std::vector<double> balance(const CsvTable& history)
{
  std::vector<double> sum(history.rows(), 0.0);
  const auto add = [&](const char* name, double sign) {
    const std::vector<double> column = history.column(name);
    for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += sign * column[n];
  };
  for (const char* gain : {"energy_elastic [J]", "energy_kinetic [J]", "loss_friction [J]",
                           "loss_rolling [J]", "loss_dashpots [J]", "loss_damping [J]"})
    add(gain, 1.0);
  for (const char* work : {"work_platens [J]", "work_side [J]", "work_gravity [J]"})
    add(work, -1.0);
  return sum;
}

}  // namespace

// Sixteen grains between two platens in a sleeve with free ends, pressed by 5 kPa from outside and
// then shaken for ever, since nothing damps: what the pressure did stays in the specimen.
TEST(SleeveEnergy, DoesNotGrowOver100000StepsWithoutDamping)
{
  const TemporaryFolder folder;
  const Outcome outcome = run_deck(
      opening_deck("grain_stack") +
          "fix side all mesh/surface/shell cylinder 0.0246 -0.002 0.082 edge 0.012 type 2 platens "
          "top bottom modulus 5e6 poisson 0.3 thickness 0.002 density 2000 top_end free "
          "bottom_end free damping 0 mass_scaling no pressure 5e3 ramp 200\n"
          "fix top all servo/platen position top z 0.08 side side type 2\n"
          "fix bottom all servo/platen position bottom z 0 side side type 2\n"
          "fix move all motion step 1e-5 damping 0\n"
          "fix history all specimen/history platens top bottom side side motion move every 200\n"
          "thermo 10000\nrun 100000\n",
      1, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const CsvTable history(folder.path() / "history.csv");
  const std::vector<double> sum = balance(history);
  const std::vector<double> elastic = history.column("energy_elastic [J]"),
                            kinetic = history.column("energy_kinetic [J]");
  double at_hand = 0.0, worst = 0.0;
  for (std::size_t n = 5; n < sum.size(); ++n)
    at_hand += (elastic[n] + kinetic[n]) / static_cast<double>(sum.size() - 5);
  for (const double s : sum) worst = std::max(worst, std::abs(s - sum[0]) / at_hand);
  std::printf("sleeve with grains: balance off by %.5f of %.2e J at hand\n", worst, at_hand);
  EXPECT_GT(kinetic.back(), 0.01 * at_hand) << "it still moves";
  EXPECT_LT(worst, 0.02);
}

TEST(SleeveEnergy, AccountOfAnEncasedTestClosesWithinTwoPercent)
{
  const TemporaryFolder folder;
  const Outcome outcome =
      run_deck(new_encased_specimen(encased_shear + "run 6000\n"), 1, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const CsvTable history(folder.path() / "history.csv");
  const std::vector<double> error = history.column("energy_error [-]");
  std::printf("encased test to %.1f %% strain: energy error %.4f, work of the platens %.3e J\n",
              100.0 * history.column("axial_strain [-]").back(), error.back(),
              history.column("work_platens [J]").back());
  EXPECT_GT(history.column("axial_strain [-]").back(), 0.05);
  for (const double e : error) EXPECT_LT(e, 0.02);
}
