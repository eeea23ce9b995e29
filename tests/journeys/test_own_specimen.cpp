// SPDX-License-Identifier: GPL-2.0-only
// A user takes own gravel, geotextile and cell to two tests, in a folder of their own with the
// installed program: the steps are those of the tutorial, what comes out is looked at here.
#include "runner/case_record.h"
#include "runner/case_variables.h"
#include "support/child_program.h"
#include "support/csv_table.h"
#include "support/tutorial.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const fs::path tutorials = fs::path(ENCASE_SOURCE) / "input_scripts/tutorials";

struct SizeClass {
  double low, high, share;
};

/// Grains of a class whose radii are uniform by number: N mean(d^3) pi/6 is its solid volume.
double expected_grains(const SizeClass& c, double solid)
{
  const double mean_cube = (std::pow(c.high, 4) - std::pow(c.low, 4)) / (4.0 * (c.high - c.low));
  return c.share * solid / (M_PI / 6.0 * mean_cube);
}

double counted_grains(const fs::path& report)
{
  const std::string text = read_text(report), words = "# count [-],";
  return std::stod(text.substr(text.find(words) + words.size()));
}

}  // namespace

TEST(OwnSpecimen, IsTestedAtTwoStressesFromAFolderOfOnesOwn)
{
  const TemporaryFolder home;
  const fs::path clone = clone_in(home.path());
  ASSERT_EQ(follow(read_steps(tutorials / "own_specimen.md"), home.path(), clone), "");

  const double volume = M_PI * 0.15 * 0.15 * 0.60, solid = (1.0 - 0.46) * volume;
  double grains = 0.0;
  for (const SizeClass& c :
       {SizeClass{0.025, 0.032, 0.1}, SizeClass{0.032, 0.040, 0.4}, SizeClass{0.040, 0.050, 0.5}})
    grains += expected_grains(c, solid);
  double first_stress = 0.0;
  for (const auto& [id, stress] : {std::pair{"gravel_080", 80e3}, {"gravel_200", 200e3}}) {
    SCOPED_TRACE(id);
    const fs::path folder = home.path() / "large_cell/runs/look" / id;
    const CsvTable history(folder / "history.csv");
    EXPECT_NEAR(history.column("height [m]").front(), 0.60, 0.60 * 0.02);
    EXPECT_NEAR(history.column("radius [m]").front(), 0.15, 0.15 * 0.02);
    EXPECT_NEAR(history.column("confining_stress [Pa]").back(), stress, 1e-3 * stress);
    EXPECT_GE(history.column("axial_strain [-]").back(), 0.009);
    const double q = history.column("deviatoric_stress_bottom [Pa]").back();
    EXPECT_GT(q, first_stress) << "more confined, and no stronger";
    first_stress = q;
    EXPECT_NEAR(counted_grains(folder / "gradation.csv"), grains, 2.0);
    const Settings used = read_used_variables(folder / "variables.csv");
    EXPECT_EQ(fs::path(*value_in(used, "strip")), home.path() / "large_cell/woven.csv");
  }
}
