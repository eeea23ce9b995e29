// SPDX-License-Identifier: GPL-2.0-only
// Density scaling in a run: what it does to the energy and momentum of grains that move.
#include "verification/contact/grain_deck.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

using namespace encased_column::testing;

namespace {

/// Four columns of nine grains that almost touch, each some tenths of a millimetre off its place,
/// between walls; the upper platen comes down on them. No friction, no damping.
std::string stack(const std::string& motion, const std::string& speed, int steps)
{
  std::string grains;
  unsigned random = 1;
  const auto off = [&random] {
    random = random * 1664525u + 1013904223u;
    return 6e-4 * ((random >> 8) / 16777216.0 - 0.5);
  };
  for (int layer = 0; layer < 9; ++layer)
    for (const double x : {-0.0105, 0.0105})
      for (const double y : {-0.0105, 0.0105}) {
        const double place[3] = {x + off(), y + off(), 0.0105 + 0.0208 * layer + off()};
        grains += grain(place[0], place[1], place[2]);
      }
  return material(7e6, 0.0) + grains + grain_size +
         "fix side all servo/cylinder radius 0.0262 platens top bottom type 2\n" +
         platen("top", 0.1877) + platen("bottom", 0.0) +
         "fix move all motion damping 0 safety 0.1 every 50 " + motion + "\n" +
         "fix history all specimen/history platens top bottom side side motion move every 50\n"
         "fix_modify top velocity " +
         speed + "\nthermo 100000\nrun " + std::to_string(steps) + "\n";
}

/// The largest energy [J] over the rows that comes from nowhere or is lost, over what came in.
double error_of(const std::string& deck)
{
  const TemporaryFolder folder;
  const Outcome outcome = run_deck(deck, 1, folder.path());
  if (outcome.exit_code != 0) throw std::runtime_error(outcome.output);
  const CsvTable history(folder.path() / "history.csv");
  double worst = 0.0;
  for (std::size_t n = 0; n < history.column("step [-]").size(); ++n) {
    const auto at = [&](const char* name) { return history.column(name)[n]; };
    const double in = at("work_platens [J]") + at("work_side [J]");
    const double out = at("energy_elastic [J]") + at("energy_kinetic [J]") + at("loss_damping [J]");
    worst = std::max(worst, std::abs(in - out));
  }
  const double in = history.column("work_platens [J]").back();
  EXPECT_GT(in, 5e-4);
  EXPECT_GT(history.column("energy_elastic [J]").back(), 1e-5);
  return worst / in;
}

}  // namespace

// The error of true masses is that of the step's length. Where masses rose at a kept velocity,
// density scaling made 0.43 of what the platen brought in out of nothing.
TEST(DensityScaling, OfAStackThatAPlatenShakesIsAsGoodAsTrueMasses)
{
  const double scaled = error_of(stack("step 1.0", "5e-6", 8000));
  const double stable = error_of(stack("step stable", "0.04", 8000));
  std::printf("stack: energy error %.1e with density scaling, %.1e with true masses\n", scaled,
              stable);
  EXPECT_LT(scaled, 5e-4);
  EXPECT_LT(stable, 5e-4);
}
