// SPDX-License-Identifier: GPL-2.0-only
#include "measure/specimen_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace encased_column;

namespace {

constexpr double edge = 0.02;      // of the cells of a simple cubic lattice [m]
constexpr double pressing = 3.0;   // along z, of each contact [N]
constexpr double squeezing = 2.0;  // along x and y [N]
constexpr int across = 4, up = 9;  // cells

/// The sums over a lattice of touching grains about the z axis, each grain seen with its six
/// contacts as with walls, so that it counts alone.
SpecimenSums lattice_sums()
{
  SpecimenSums sums;
  sums.start({0.0, up * edge}, Vec3::Zero());
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < across; ++j)
      for (int k = 0; k < up; ++k) {
        const Vec3 x = edge * Vec3(i + 0.5 - 0.5 * across, j + 0.5 - 0.5 * across, k + 0.5);
        for (int a = 0; a < 3; ++a)
          for (const double way : {-1.0, 1.0}) {
            const Vec3 normal = way * Vec3::Unit(a);
            sums.add(SeenContact{x, 0.5 * edge, true, false, Vec3::Zero(), 0.0, normal,
                                 -(a == 2 ? pressing : squeezing) * normal, 0.5 * edge, 0.5 * edge,
                                 0.5, false, 4.0});
          }
        sums.add(SeenGrain{x, Vec3(0.0, 0.0, 2.0), Vec3::Zero(), 0.5 * edge, 0.1, 0.4, 6},
                 Vec3(0.0, 0.0, -10.0));
      }
  return sums;
}

SpecimenSample lattice_sample()
{
  SpecimenSample sample{};
  sample.sums = lattice_sums().numbers();
  sample.before.state.height = sample.now.state.height = up * edge;
  sample.before.state.volume = sample.now.state.volume = across * across * up * edge * edge * edge;
  return sample;
}

double number_of(const std::string& name, const SpecimenSample& sample)
{
  for (const Column<SpecimenSample>& column : specimen_columns())
    if (name == column.name.name) return column.value(sample);
  throw std::runtime_error("no column " + name);
}

}  // namespace

// Each cell bears its force over its face, whatever direction the axis is seen from.
TEST(SpecimenSums, GiveTheStressOfALatticeInItsCore)
{
  const SpecimenSample sample = lattice_sample();
  EXPECT_NEAR(number_of("core_axial_stress", sample), pressing / (edge * edge), 1e-8);
  EXPECT_NEAR(number_of("core_radial_stress", sample), squeezing / (edge * edge), 1e-8);
  const double grain = std::acos(-1.0) / 6.0 * edge * edge * edge;
  EXPECT_NEAR(sample.sums.core_solid, across * across * up / 3 * grain, 1e-15);
}

TEST(SpecimenSums, CountGrainsContactsAndEnergies)
{
  const SpecimenSample sample = lattice_sample();
  const double grains = across * across * up;
  EXPECT_EQ(sample.sums.grains, grains);
  EXPECT_EQ(number_of("coordination_number", sample), 6.0);
  EXPECT_NEAR(number_of("porosity", sample), 1.0 - std::acos(-1.0) / 6.0, 1e-12);
  EXPECT_NEAR(sample.sums.elastic, grains * 6 * 0.5 * 4.0, 1e-9);
  EXPECT_NEAR(sample.sums.kinetic, grains * 0.5 * 0.4 * 4.0, 1e-9);
  EXPECT_NEAR(sample.sums.weight_height, -grains * 0.1 * 10.0 * 0.5 * up * edge, 1e-9);
}

TEST(SpecimenColumns, CountStrainsWorksAndLossesFromTheReference)
{
  SpecimenSample sample = lattice_sample();
  sample.now.state.height *= 0.9;
  sample.now.state.volume *= 1.02;
  sample.before.state.radius[2] = 0.05;
  sample.now.state.radius[2] = 0.06;
  sample.before.energy.work_side = 5.0;
  sample.now.energy.work_side = 3.0;
  sample.before.energy.kinetic = 7.0;
  sample.now.energy.kinetic = 8.0;
  EXPECT_NEAR(number_of("axial_strain", sample), 0.1, 1e-12);
  EXPECT_NEAR(number_of("volumetric_strain", sample), -0.02, 1e-12);
  EXPECT_NEAR(number_of("radial_strain_75", sample), -0.2, 1e-12);
  EXPECT_EQ(number_of("work_side", sample), -2.0);
  EXPECT_EQ(number_of("energy_kinetic", sample), 8.0) << "stored energy does not count from there";
}

// Decks and readers know the columns by name and by place: those of a history that the program
// wrote before they were a list, and new ones behind them.
TEST(SpecimenColumns, KeepTheirNamesAndPlaces)
{
  const std::string before =
      "step [-],axial_strain [-],stress_top [Pa],stress_bottom [Pa],"
      "confining_stress [Pa],deviatoric_stress_top [Pa],deviatoric_stress_bottom [Pa],"
      "mean_stress [Pa],volumetric_strain [-],height [m],radius [m],porosity [-],"
      "porosity_less_overlap [-],coordination_number [-],"
      "mechanical_coordination_number [-],radial_strain_25 [-],radial_strain_50 [-],"
      "radial_strain_75 [-],unbalanced_average [-],unbalanced_maximum [-],"
      "inertial_number [-],work_platens [J],work_side [J],work_gravity [J],"
      "energy_elastic [J],energy_kinetic [J],loss_friction [J],loss_rolling [J],"
      "loss_dashpots [J],loss_damping [J],energy_error [-],core_axial_stress [Pa],"
      "core_radial_stress [Pa],loss_yielding [J],unbalanced_bearing [-]";
  std::string now;
  for (const std::string& heading : headings_of(specimen_columns()))
    now += (now.empty() ? "" : ",") + heading;
  EXPECT_EQ(now, before);
}
