// SPDX-License-Identifier: GPL-2.0-only
#include "support/child_program.h"
#include "support/csv_table.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column::testing;

namespace {

const double pi = std::acos(-1.0);

/// The stack of grains, shortened by 0.2 mm and brought to rest, with spheres that measure it.
std::string pressed_stack(const std::string& spheres)
{
  return opening_deck("grain_stack") +
         "fix side all servo/cylinder radius 0.05 platens top bottom type 2\n"
         "fix top all servo/platen position top z 0.08 side side type 2\n"
         "fix bottom all servo/platen position bottom z 0 side side type 2\n"
         "fix move all motion step 1.0\n" +
         spheres +
         "fix_modify top velocity 5e-7\nrun 400\nfix_modify top hold\nrun 1600\n"
         "variable force equal f_top[2]\nprint \"force ${force}\"\n";
}

CsvTable measured(const std::string& spheres, int ranks, double* force)
{
  const TemporaryFolder folder;
  const Outcome outcome = run_deck(pressed_stack(spheres), ranks, folder.path());
  if (outcome.exit_code != 0) throw std::runtime_error(outcome.output);
  *force = outcome.value("force");
  return CsvTable(folder.path() / "spheres.csv");
}

}  // namespace

// In equilibrium the stress of a whole specimen times its volume is the platens' force times the
// way between the contacts there, which lie in the middle of the overlaps; a sphere that holds all
// of it, platens and all, must find the same.
TEST(MeasureSphere, AroundAWholeSpecimenFindsTheStressOfItsPlatens)
{
  double force = 0.0;
  const CsvTable table =
      measured("fix ball all measure/sphere sphere 0 0 0.04 0.2 every 400\n", 1, &force);
  const double volume = 4.0 / 3.0 * pi * 0.2 * 0.2 * 0.2, wall_stiffness = pi * 0.01 * 7e6;
  const double axial = table.column("axial_stress [Pa]").back();
  const double height = 0.08 - 2e-4 + force / 4.0 / wall_stiffness;
  EXPECT_GT(force, 20.0);
  EXPECT_NEAR(axial * volume, force * height, 1e-6 * force * height);
  EXPECT_NEAR(table.column("radial_stress [Pa]").back(), 0.0, 1e-9 * axial);
  EXPECT_EQ(table.column("grains [-]").back(), 16.0);
  // Two contacts a grain, the platens' among them; every contact of a column bears the same.
  EXPECT_EQ(table.column("coordination_number [-]").back(), 2.0);
  EXPECT_NEAR(table.column("mean_contact_force [N]").back(), force / 4.0, 1e-6 * force);
  EXPECT_NEAR(table.column("largest_contact_force [N]").back(), force / 4.0, 1e-6 * force);
  EXPECT_DOUBLE_EQ(table.column("fabric_zz [-]").back(), 1.0);
  const double solid = 16.0 * 4.0 / 3.0 * pi * 1e-6;
  EXPECT_NEAR(table.column("porosity [-]").back(), 1.0 - solid / volume, 1e-12);
}

TEST(MeasureSphere, StackFollowsThePlatensAndIsTheSameOnTwoAndFourRanks)
{
  const std::string stack =
      "fix balls all measure/sphere stack 3 0.02 platens top bottom every 400 folder spheres\n";
  double force = 0.0;
  const CsvTable table = measured(stack, 1, &force);
  ASSERT_EQ(table.rows(), 18u);  // three spheres, before the first step and after 400 to 2000
  const std::vector<double>& z = table.column("z [m]");
  EXPECT_NEAR(z[15], 0.02, 1e-12);
  EXPECT_NEAR(z[16], 0.5 * (0.08 - 2e-4), 1e-9);
  EXPECT_NEAR(z[17], 0.08 - 2e-4 - 0.02, 1e-9);
  for (const int ranks : {2, 4}) {
    const CsvTable again = measured(stack, ranks, &force);
    for (const char* name :
         {"grains [-]", "porosity [-]", "porosity_less_overlap [-]", "coordination_number [-]",
          "axial_stress [Pa]", "mean_contact_force [N]", "largest_contact_force [N]"})
      for (std::size_t n = 0; n < table.rows(); ++n)
        EXPECT_NEAR(table.column(name)[n], again.column(name)[n],
                    1e-9 * std::abs(table.column(name)[n]))
            << name << " in row " << n << " on " << ranks << " ranks";
  }
}

// Five grains in a row across a sleeve, 0.2 mm too long for it: pressed by the sleeve at both ends
// and kept from giving way sideways.
// At rest all contacts bear the same F, found again from where the grains are, and V sigma is F
// times the way between the contacts at the ends.
TEST(MeasureSphere, AroundARowAcrossASleeveFindsWhatTheSleeveBears)
{
  std::string grains;
  for (int n = -2; n <= 2; ++n)
    grains += "create_atoms 1 single " + std::to_string(0.02 * n) + " 0 0.05 units box\n";
  const Outcome outcome = run_deck(
      opening_deck("empty_cylinder") + grains +
      "set group all diameter 0.02 density 2500\n"
      "fix side all mesh/surface/shell cylinder 0.0499 0 0.2 edge 0.01 type 2 platens top bottom "
      "modulus 11.5e6 poisson 0.3 thickness 0.01 density 30 rigid yes\n"
      "fix top all servo/platen position top z 0.2 side side type 2\n"
      "fix bottom all servo/platen position bottom z 0 side side type 2\n"
      "fix line all setforce NULL 0 0\n"
      "fix move all motion step 1.0\n"
      "fix ball all measure/sphere sphere 0 0 0.05 0.08 every 1000\nrun 4000\n"
      "variable gap equal x[4]-x[3]\nvariable first equal x[1]\nvariable last equal x[5]\n"
      "variable xx equal f_ball[1][15]\nvariable radial equal f_ball[1][13]\n"
      "variable hoop equal f_ball[1][14]\nvariable ends equal f_ball[1][10]\n"
      "print \"gap ${gap}\"\nprint \"first ${first}\"\nprint \"last ${last}\"\n"
      "print \"xx ${xx}\"\nprint \"radial ${radial}\"\nprint \"hoop ${hoop}\"\n"
      "print \"ends ${ends}\"\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const double force = 0.5 * pi * 0.01 * 7e6 * (0.02 - outcome.value("gap"));
  const double length = outcome.value("last") - outcome.value("first") + 0.02;
  const double volume = 4.0 / 3.0 * pi * std::pow(0.08, 3);
  EXPECT_GT(force, 2.0);
  EXPECT_EQ(outcome.value("ends"), 2.0);
  EXPECT_NEAR(outcome.value("xx") * volume, force * length, 2e-3 * force * length);
  EXPECT_NEAR(outcome.value("radial"), outcome.value("xx"), 1e-6 * outcome.value("xx"));
  EXPECT_NEAR(outcome.value("hoop"), 0.0, 1e-6 * outcome.value("xx"));
}

TEST(MeasureSphere, WarnsOnceOfASphereWithFewGrains)
{
  const Outcome outcome =
      run_deck(pressed_stack("fix ball all measure/sphere sphere 0 0 0.04 0.2 every 400\n"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const std::string sentence = "measuring sphere 1 of fix 'ball' holds 16 grains at step 0";
  EXPECT_TRUE(outcome.says(sentence)) << outcome.output;
  EXPECT_EQ(outcome.output.find("measuring sphere", outcome.output.find(sentence) + 1),
            std::string::npos);
}
