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

TEST(MeasureSphere, StackFollowsThePlatensAndIsTheSameOnTwoRanks)
{
  const std::string stack =
      "fix balls all measure/sphere stack 3 0.02 platens top bottom every 400 folder spheres\n";
  double one = 0.0, two = 0.0;
  const CsvTable table = measured(stack, 1, &one), again = measured(stack, 2, &two);
  ASSERT_EQ(table.rows(), 18u);  // three spheres, before the first step and after 400 to 2000
  const std::vector<double>& z = table.column("z [m]");
  EXPECT_NEAR(z[15], 0.02, 1e-12);
  EXPECT_NEAR(z[16], 0.5 * (0.08 - 2e-4), 1e-9);
  EXPECT_NEAR(z[17], 0.08 - 2e-4 - 0.02, 1e-9);
  for (const char* name : {"porosity [-]", "coordination_number [-]", "axial_stress [Pa]",
                           "mean_contact_force [N]", "largest_contact_force [N]"})
    for (std::size_t n = 0; n < table.rows(); ++n)
      EXPECT_NEAR(table.column(name)[n], again.column(name)[n],
                  1e-9 * std::abs(table.column(name)[n]))
          << name << " in row " << n;
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
