// SPDX-License-Identifier: GPL-2.0-only
// The geotextile as a material: strips, wrinkles, yield and tear against closed forms.
#include "shell/cloth.h"

#include "core/constants.h"
#include "shell_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

constexpr double strip_stiffness = 115e3;  // J [N/m], Table 3 of the study

ShellConstants geotextile_of_table_3()
{
  ShellConstants c;
  c.modulus_hoop = strip_stiffness / 0.01;
  c.poisson = 0.3;
  c.thickness = 0.01;
  c.density = 30.0;
  return c;
}

/// A strip along one direction, free to contract across: pulled step by step.
class StripTest {
 public:
  explicit StripTest(const ShellConstants& c, int direction = 0, const ClothFacet& facet = {})
      : material_(c),
        direction_(direction),
        facet_(facet)
  {
  }

  /// Tension [N/m] at a strain, when nothing relaxes any more.
  double pull_to(double strain)
  {
    const Cloth& cloth = material_.cloth();
    const double across = material_.membrane()(1 - direction_, 1 - direction_);
    strain_(direction_) = strain;
    PlaneVector force;
    for (int n = 0; n < 100; ++n) {
      for (int free = 0; free < 20; ++free) {
        force = material_.membrane_force(strain_, memory);
        if (memory.left() > 0.0)
          strain_(1 - direction_) -= force(1 - direction_) / (across * memory.left());
      }
      const PlaneVector elastic = ShellMaterial::elastic_strain(strain_, memory);
      stored = ShellMaterial::membrane_energy(elastic, force);
      if (cloth.yields()) dissipated += cloth.follow({force, elastic(2), stored}, facet_, memory);
    }
    return force(direction_);
  }
  double pull_slowly_to(double strain, int steps)
  {
    const double from = strain_(direction_);
    double tension = 0.0, before = material_.membrane_force(strain_, memory)(direction_);
    for (int n = 1; n <= steps; ++n) {
      const double e = from + n * (strain - from) / steps;
      tension = pull_to(e);
      work += 0.5 * (before + tension) * (strain - from) / steps;
      before = tension;
    }
    return tension;
  }

  FacetMemory memory;
  double dissipated = 0.0, stored = 0.0, work = 0.0;  // [J/m^2]

 private:
  ShellMaterial material_;
  int direction_;
  ClothFacet facet_;
  PlaneVector strain_ = PlaneVector::Zero();
};

std::string refusal_of(const ShellConstants& c)
{
  try {
    const ShellMaterial material(c);
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "";
}

}  // namespace

TEST(Strip, FollowsTheTableOfTheLaboratoryWhateverItsDirection)
{
  for (const bool tension_only : {false, true})
    for (const int direction : {0, 1}) {
      ShellConstants c = geotextile_of_table_3();
      c.tension_only = tension_only;
      for (auto& table : c.cloth.strip) table = {{0.0, 0.0}, {0.02, 2300.0}, {0.08, 9200.0}};
      StripTest strip(c, direction);
      for (const double e : {0.02, 0.04, 0.06, 0.08})
        EXPECT_NEAR(strip.pull_to(e), strip_stiffness * e, 1e-10 * 9200.0);
      EXPECT_NEAR(strip.stored, 368.0, 1e-8);
    }
}

TEST(Strip, FollowsACurvedTableAndUnloadsByItsFirstSlope)
{
  ShellConstants c = geotextile_of_table_3();
  c.cloth.strip[0] = {{0.0, 0.0}, {0.02, 2300.0}, {0.06, 4300.0}, {0.10, 5100.0}};
  StripTest strip(c);
  EXPECT_NEAR(strip.pull_to(0.01), 1150.0, 1e-7);
  EXPECT_NEAR(strip.pull_to(0.04), 3300.0, 1e-7);
  EXPECT_NEAR(strip.pull_to(0.08), 4700.0, 1e-7);
  EXPECT_NEAR(strip.memory.plastic_strain[0], 0.08 - 4700.0 / strip_stiffness, 1e-12);
  EXPECT_NEAR(strip.pull_to(0.07), 4700.0 - 0.01 * strip_stiffness, 1e-7);
  EXPECT_NEAR(strip.pull_to(0.08), 4700.0, 1e-7);
  // Beyond the last reading its last slope goes on.
  EXPECT_NEAR(strip.pull_to(0.12), 5500.0, 1e-7);
}

// A cloth that stiffens as its yarns straighten, and unloads by its steepest slope.
TEST(Strip, FollowsATableThatStiffensWithAGivenUnloadingStiffness)
{
  ShellConstants c = geotextile_of_table_3();
  c.cloth.strip[0] = {{0.0, 0.0}, {0.02, 400.0}, {0.04, 2700.0}, {0.06, 3700.0}};
  StripTest strip(c);
  for (const auto& [e, tension] : {std::pair{0.01, 200.0},
                                   {0.02, 400.0},
                                   {0.03, 1550.0},
                                   {0.04, 2700.0},
                                   {0.05, 3200.0},
                                   {0.06, 3700.0}})
    EXPECT_NEAR(strip.pull_to(e), tension, 1e-7) << "at " << e;
  EXPECT_NEAR(strip.pull_to(0.05), 3700.0 - 0.01 * strip_stiffness, 1e-7);
}

TEST(Strip, YieldsAtItsStrengthAndDissipatesTensionTimesPlasticStrain)
{
  ShellConstants c = geotextile_of_table_3();
  c.cloth.strength = {4600.0, 9200.0};
  c.cloth.after = AfterStrength::yield;
  StripTest strip(c);
  EXPECT_NEAR(strip.pull_to(0.04), 4600.0, 1e-7);
  EXPECT_EQ(strip.memory.plastic_strain[0], 0.0);
  for (double e = 0.05; e < 0.085; e += 0.01) EXPECT_NEAR(strip.pull_to(e), 4600.0, 1e-7);
  EXPECT_NEAR(strip.memory.plastic_strain[0], 0.04, 1e-12);
  EXPECT_EQ(strip.memory.plastic_strain[1], 0.0);
  EXPECT_NEAR(strip.dissipated, 4600.0 * 0.04, 1e-8);
  EXPECT_NEAR(strip.pull_to(0.06), 2300.0, 1e-7);
  EXPECT_NEAR(strip.pull_to(0.04), 0.0, 1e-7);
  EXPECT_NEAR(strip.pull_to(0.08), 4600.0, 1e-7);
  EXPECT_NEAR(strip.dissipated, 4600.0 * 0.04, 1e-8);
}

// N = N_u + H (e - e_u) past the strain e_u at which the table, or J alone, has the strength.
TEST(Strip, HardensPastItsStrengthByTheGivenSlopeOfTensionOverStrain)
{
  const double hardening = 10e3;
  for (const bool has_table : {false, true})
    for (const double share : {1.0, 0.7}) {
      ShellConstants c = geotextile_of_table_3();
      if (has_table) c.cloth.strip[0] = {{0.0, 0.0}, {0.02, 2300.0}, {0.06, 4300.0}};
      c.cloth.strength = {4600.0, 9200.0};
      c.cloth.after = AfterStrength::yield;
      c.cloth.hardening = hardening;
      const double strength = share * 4600.0;
      const double there =
          has_table ? 0.02 + (strength - 2300.0) / 50e3 : strength / strip_stiffness;
      for (const int steps : {1, 10}) {  // by one long step the same
        StripTest strip(c, 0, {{1.0, 1.0}, {share, 1.0}});
        for (int n = 1; n <= steps; ++n) strip.pull_to(n * (there + 0.1) / steps);
        const double tension = strength + 0.1 * hardening;
        EXPECT_NEAR(strip.pull_to(there + 0.1), tension, 1e-7);
        EXPECT_NEAR(strip.memory.plastic_strain[0], there + 0.1 - tension / strip_stiffness, 1e-12);
        EXPECT_EQ(strip.memory.plastic_strain[1], 0.0);
        EXPECT_NEAR(strip.pull_to(there + 0.09), tension - 0.01 * strip_stiffness, 1e-7);
        EXPECT_NEAR(strip.pull_to(there + 0.2), tension + 0.1 * hardening, 1e-7);
      }
    }
}

// A table that is level where it has the strength does not keep the cloth from hardening there.
TEST(Strip, HardensBehindATableThatEndsLevel)
{
  ShellConstants c = geotextile_of_table_3();
  c.cloth.strip[0] = {{0.0, 0.0}, {0.02, 2300.0}, {0.06, 4300.0}, {0.10, 4300.0}};
  c.cloth.strength = {4300.0, 9200.0};
  c.cloth.after = AfterStrength::yield;
  c.cloth.hardening = 10e3;
  for (const int steps : {1, 10}) {
    StripTest strip(c);
    for (int n = 1; n <= steps; ++n) strip.pull_to(n * 0.16 / steps);
    EXPECT_NEAR(strip.pull_to(0.16), 5300.0, 1e-7);
    EXPECT_NEAR(strip.pull_to(0.26), 6300.0, 1e-7);
  }
}

TEST(Strip, SplitsItsWorkIntoWhatIsStoredAndWhatIsDissipated)
{
  ShellConstants c = geotextile_of_table_3();
  c.cloth.strip[0] = {{0.0, 0.0}, {0.02, 2300.0}, {0.06, 4300.0}, {0.10, 5100.0}};
  StripTest strip(c);
  strip.pull_slowly_to(0.10, 1000);
  strip.pull_slowly_to(0.05, 100);
  // By the areas of the table's trapezoids, less the triangle of the unloading.
  const double loading = 0.5 * 0.02 * 2300.0 + 0.04 * 3300.0 + 0.04 * 4700.0;
  const double elastic = 0.5 * 5100.0 * 5100.0 / strip_stiffness;
  EXPECT_NEAR(strip.dissipated, loading - elastic, 1e-4 * loading);
  EXPECT_NEAR(strip.work, strip.stored + strip.dissipated, 1e-4 * loading);
}

// N = N_u (1 - w / w_c), w = h (e - N / J): a line in the strain from N_u / J to w_c / h.
TEST(Strip, TearsAlongTheLineOfItsCrackAndUnloadsTowardsTheOrigin)
{
  ShellConstants c = geotextile_of_table_3();
  c.cloth.strength = {9200.0, 9200.0};
  c.cloth.after = AfterStrength::tear;
  c.cloth.fracture_energy = 100.0;
  const double width = 0.1, opening = 2.0 * 100.0 / 9200.0;
  EXPECT_NEAR(opening, 21.7e-3, 5e-5);
  StripTest strip(c, 0, {{width, width}});
  EXPECT_NEAR(strip.pull_to(0.08), 9200.0, 1e-7);
  for (const double share : {0.25, 0.5, 0.75}) {
    const double e = 0.08 + share * (opening / width - 0.08);
    EXPECT_NEAR(strip.pull_to(e), (1.0 - share) * 9200.0, 1e-6);
    EXPECT_NEAR(strip.pull_to(0.5 * e), 0.5 * (1.0 - share) * 9200.0, 1e-6);
  }
  EXPECT_NEAR(strip.pull_to(1.001 * opening / width), 0.0, 1e-4);
  EXPECT_GE(strip.memory.damage[0], Cloth::torn);
}

TEST(Strip, TakesItsFractureEnergyWhileItTears)
{
  ShellConstants c = geotextile_of_table_3();
  c.cloth.strip[1] = {{0.0, 0.0}, {0.02, 2300.0}, {0.06, 4300.0}};
  c.cloth.strength = {9200.0, 3300.0};
  c.cloth.after = AfterStrength::tear;
  c.cloth.fracture_energy = 100.0;
  for (const int direction : {0, 1}) {
    const double width = 0.05;
    StripTest strip(c, direction, {{width, width}});
    strip.pull_slowly_to(2.0 * 100.0 / c.cloth.strength[direction] / width + 0.05, 20000);
    EXPECT_GE(strip.memory.damage[direction], Cloth::torn);
    // The axial strip yields before: the plastic work of its table up to 3.3 kN/m at 4 %.
    const double plastic = direction == 0 ? 0.0
                                          : 0.5 * 2300.0 * 0.02 + 0.02 * 2800.0 -
                                                0.5 * 3300.0 * 3300.0 / strip_stiffness;
    EXPECT_NEAR(strip.dissipated, plastic + 100.0 / width, 1e-3 * 100.0 / width);
    EXPECT_NEAR(strip.work, strip.dissipated, 1e-3 * strip.work);
  }
}

// Its strain is that of a gap: what it bore along the tear or in shear would hold the gap together.
TEST(Strip, HalfTornBearsHalfAndTornThroughBearsNothing)
{
  ShellConstants c = geotextile_of_table_3();
  c.cloth.strength = {9200.0, 9200.0};
  c.cloth.after = AfterStrength::tear;
  c.cloth.fracture_energy = 100.0;
  for (const bool tension_only : {false, true}) {
    c.tension_only = tension_only;
    const ShellMaterial material(c);
    const PlaneVector strain(0.3, 0.02, 0.1);
    const PlaneVector whole = material.membrane_force(strain);
    for (const int direction : {0, 1})
      for (const double damage : {0.5, 1.0}) {
        FacetMemory memory;
        memory.damage[direction] = damage;
        const PlaneVector force = material.membrane_force(strain, memory);
        EXPECT_LT((force - (1.0 - damage) * whole).norm(), 1e-12 * whole.norm());
      }
  }
}

// Sheared by more than where it began to tear it slides: by N_s = G t times the strain it began
// with, less its damage. Dissipated at a strain that stands is what is no longer stored.
TEST(Strip, SlidesAlongItsTearAndDissipatesWhatItNoLongerStores)
{
  ShellConstants c = geotextile_of_table_3();
  c.cloth.strength = {9200.0, 9200.0};
  c.cloth.after = AfterStrength::tear;
  c.cloth.fracture_energy = 100.0;
  const ShellMaterial material(c);
  const ClothFacet facet{{0.05, 0.05}};
  const double bending = 3.0;  // J/m^2, a facet's without damage
  FacetMemory memory;
  const auto answer = [&](const PlaneVector& strain) {
    const PlaneVector force = material.membrane_force(strain, memory);
    const PlaneVector elastic = ShellMaterial::elastic_strain(strain, memory);
    return ClothAnswer{force, elastic(2),
                       ShellMaterial::membrane_energy(elastic, force) + memory.left() * bending};
  };
  const double began = 0.004, shear_stiffness = strip_stiffness / 2.6;
  for (const PlaneVector& strain : {PlaneVector(0.09, -0.02, began), PlaneVector(0.12, -0.02, 0.01),
                                    PlaneVector(0.15, -0.02, -0.02), PlaneVector(0.02, 0.0, 0.0)}) {
    const double stored = answer(strain).energy;
    const double taken = material.cloth().follow(answer(strain), facet, memory);
    EXPECT_NEAR(taken, stored - answer(strain).energy, 1e-10 * stored);
    const double slid = material.membrane_force(strain, memory)(2);
    EXPECT_NEAR(std::abs(slid), memory.left() * shear_stiffness * began, 1e-10 * strip_stiffness);
    EXPECT_GE(slid * strain(2), 0.0);
  }
  EXPECT_GT(memory.damage[0], 0.3);
  EXPECT_NEAR(memory.slip, -0.004, 1e-12);
}

// Strains of a column at constant volume: hoop 1 / sqrt(1 - axial) - 1; stress on its section.
TEST(StuckShell, BearsAxialCompressionUnlessItWrinkles)
{
  ShellConstants c = geotextile_of_table_3();
  for (const auto& [axial, elastic_tension, elastic_stress, tension] :
       {std::array{0.05, 1387.0, 213.4e3, 2988.0}, {0.10, 3045.0, 423.5e3, 6221.0}}) {
    const PlaneVector strain(1.0 / std::sqrt(1.0 - axial) - 1.0, -axial, 0.0);
    const double hoop = strip_stiffness / 0.91 * (strain(0) - 0.3 * axial);
    const double along = strip_stiffness / 0.91 * (0.3 * strain(0) - axial);
    c.tension_only = false;
    const PlaneVector elastic = ShellMaterial(c).membrane_force(strain);
    EXPECT_NEAR(elastic(0), hoop, 1e-9 * hoop);
    EXPECT_NEAR(elastic(0), elastic_tension, 0.5);
    EXPECT_NEAR(elastic(1), along, 1e-9 * hoop);
    EXPECT_NEAR(-2.0 * elastic(1) / 0.05, elastic_stress, 50.0);
    c.tension_only = true;
    const PlaneVector wrinkled = ShellMaterial(c).membrane_force(strain);
    EXPECT_NEAR(wrinkled(0), strip_stiffness * strain(0), 1e-10 * wrinkled(0));
    EXPECT_NEAR(wrinkled(0), tension, 0.5);
    EXPECT_NEAR(wrinkled(1), 0.0, 1e-10 * wrinkled(0));
  }
}

TEST(Wrinkles, OfASimpleShearCarryAQuarterOfTheStiffnessTimesTheAngle)
{
  ShellConstants c = geotextile_of_table_3();
  const double angle = 0.01;
  const double elastic = ShellMaterial(c).membrane_force({0.0, 0.0, angle})(2);
  c.tension_only = true;
  const PlaneVector n = ShellMaterial(c).membrane_force({0.0, 0.0, angle});
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(n(i), strip_stiffness * angle / 4.0, 1e-9);
  EXPECT_NEAR(n(2) / elastic, 0.65, 1e-12);
}

// Two principal strains a and b, a the larger one: both directions pull where b + nu a > 0, else a
// alone, like a strip, and nothing where it is no stretch (Pipkin, IMA J. Appl. Math. 36 (1986)
// 85-99), in any axes and to round-off, close to the borders between these too.
TEST(Wrinkles, FollowThePrincipalStrainsToRoundOff)
{
  ShellConstants c = geotextile_of_table_3();
  c.tension_only = true;
  const ShellMaterial material(c);
  RandomVectors random(23);
  int kind[3] = {0, 0, 0};
  for (int n = 0; n < 20000; ++n) {
    const Vec3 any = random();
    const double size = std::pow(10.0, -4.0 + 3.0 * any.z());
    double a = size * any.x(), b = size * any.y();
    if (n % 4 == 1) b = -0.3 * a * (1.0 + 1e-9 * any.y());
    if (n % 4 == 2) a = 1e-9 * size * any.x();
    if (a < b) std::swap(a, b);
    const int pulls = b + 0.3 * a > 0.0 ? 2 : a > 0.0 ? 1 : 0;
    ++kind[pulls];
    const double along = pulls == 2   ? strip_stiffness / 0.91 * (a + 0.3 * b)
                         : pulls == 1 ? strip_stiffness * a
                                      : 0.0;
    const double across = pulls == 2 ? strip_stiffness / 0.91 * (b + 0.3 * a) : 0.0;
    const double angle = pi * random().x(), x = std::cos(2.0 * angle), y = std::sin(2.0 * angle);
    const double mean = 0.5 * (a + b), half = 0.5 * (a - b);
    const PlaneVector found =
        material.membrane_force({mean + half * x, mean - half * x, 2.0 * half * y});
    const double middle = 0.5 * (along + across), difference = 0.5 * (along - across);
    const PlaneVector expected(middle + difference * x, middle - difference * x, difference * y);
    EXPECT_LT((found - expected).norm(), 1e-14 * strip_stiffness * size)
        << "strains " << a << " " << b << " at " << angle;
  }
  for (const int times : kind) EXPECT_GT(times, 2000);
}

// A strip of height h stretched by P and bent by M: fibres k (y - b), slack below b.
// Source: Stein and Hedgepeth, NASA TN D-813 (1961).
TEST(Wrinkles, OfABentStripAreAsDeepAsSteinAndHedgepethSay)
{
  ShellConstants c = geotextile_of_table_3();
  c.tension_only = true;
  const ShellMaterial material(c);
  const double height = 0.1, pull = 50.0;
  for (const auto& [moment, curvature] :
       {std::pair{0.20, 1.235}, {0.25, 1.778}, {0.30, 2.778}, {0.40, 11.11}}) {
    const double slack = (3.0 * moment - 0.5) * height;
    const double k = curvature * 2.0 * pull / (strip_stiffness * height * height);
    double force = 0.0, about_middle = 0.0;
    const int fibres = 20000;
    for (int n = 0; n < fibres; ++n) {
      const double y = (n + 0.5) * height / fibres, e = k * (y - slack);
      const double tension = material.membrane_force({e, -0.3 * std::max(e, 0.0), 0.0})(0);
      force += tension * height / fibres;
      about_middle += tension * (y - 0.5 * height) * height / fibres;
    }
    EXPECT_NEAR(force / pull, 1.0, 1e-3);  // the digits of the curvatures
    EXPECT_NEAR(about_middle / (force * height), moment, 1e-6);
  }
}

// 1 / J = c^4 / J1 + s^4 / J2 + (1 / G - 2 nu / J1) s^2 c^2
TEST(OrthotropicStrip, PulledOffItsAxesHasTheStiffnessOfTheDirection)
{
  ShellConstants c = geotextile_of_table_3();
  c.modulus_hoop = 115e3 / 0.01;
  c.modulus_axial = 60e3 / 0.01;
  c.shear_modulus = 8e3 / 0.01;
  c.poisson = 0.1;
  for (const auto& [degrees, stiffness] :
       {std::pair{15.0, 65.15e3}, {30.0, 34.43e3}, {45.0, 26.91e3}, {60.0, 30.28e3}}) {
    const double x = std::cos(degrees * pi / 180.0), y = std::sin(degrees * pi / 180.0);
    const double tension = 1000.0;
    const PlaneVector n = tension * PlaneVector(x * x, y * y, x * y);
    const PlaneVector along(x * x, y * y, x * y);          // of a strain: its elongation
    const PlaneVector across(y * y, x * x, -2.0 * x * y);  // a strain across the line alone
    c.tension_only = false;
    const PlaneVector strain = ShellMaterial(c).membrane().inverse() * n;
    EXPECT_NEAR(tension / strain.dot(along), stiffness, 2e-4 * stiffness);  // its digits
    // Wrinkles across the line of tension change nothing.
    c.tension_only = true;
    const ShellMaterial material(c);
    for (const double contraction : {1e-6, 0.01, 0.1}) {
      const PlaneVector wrinkled = material.membrane_force(strain - contraction * across);
      EXPECT_LT((wrinkled - n).norm(), 1e-9 * tension) << degrees << " " << contraction;
    }
  }
}

TEST(OrthotropicWrinkles, ForceIsTheGradientOfTheEnergyAndNeverCompressive)
{
  ShellConstants c = geotextile_of_table_3();
  c.modulus_axial = 60e3 / 0.01;
  c.shear_modulus = 8e3 / 0.01;
  c.poisson = 0.1;
  c.tension_only = true;
  const ShellMaterial material(c);
  FacetMemory memory;
  memory.plastic_strain = {0.01, 0.0};
  memory.damage = {0.3, 0.1};
  const auto energy = [&](const PlaneVector& e) {
    return ShellMaterial::membrane_energy(ShellMaterial::elastic_strain(e, memory),
                                          material.membrane_force(e, memory));
  };
  RandomVectors random(3);
  const double h = 1e-6;
  for (int n = 0; n < 200; ++n) {
    const PlaneVector e = 0.05 * random();
    const PlaneVector force = material.membrane_force(e, memory);
    for (int i = 0; i < 3; ++i) {
      const PlaneVector d = h * PlaneVector::Unit(i);
      EXPECT_NEAR((energy(e + d) - energy(e - d)) / (2.0 * h), force(i),
                  1e-4 * strip_stiffness * h + 1e-6 * strip_stiffness);
    }
    EXPECT_GE(force(0) * force(1) - force(2) * force(2), -1e-12 * force.squaredNorm() - 1e-12);
    EXPECT_GE(force(0) + force(1), -1e-9);
  }
}

TEST(Cloth, RefusesTablesAndStrengthsThatContradictEachOther)
{
  const auto with = [](const auto& change) {
    ShellConstants c = geotextile_of_table_3();
    for (auto& table : c.cloth.strip) table = {{0.0, 0.0}, {0.02, 2300.0}, {0.08, 9200.0}};
    change(c);
    return refusal_of(c);
  };
  EXPECT_EQ(with([](ShellConstants&) {}), "");
  EXPECT_NE(with([](ShellConstants& c) {
              c.cloth.strip[0][0].strain = 0.01;
            }).find("must start at 0 strain and 0 hoop tension, found 0.01 and 0 N/m"),
            std::string::npos);
  EXPECT_NE(with([](ShellConstants& c) {
              c.cloth.strip[1][2].strain = 0.02;
            }).find("strains that increase from row to row, found 0.02 after 0.02 in row 3"),
            std::string::npos);
  EXPECT_NE(with([](ShellConstants& c) {
              c.cloth.strip[1][1].tension = -1.0;
            }).find("no negative tension, found -1 N/m in the axial direction in row 2"),
            std::string::npos);
  EXPECT_NE(with([](ShellConstants& c) {
              c.cloth.strip[0][2].tension = 2000.0;
            }).find("do not fall from row to row, found 2000 after 2300"),
            std::string::npos);
  EXPECT_NE(with([](ShellConstants& c) { c.modulus_hoop = 1e7; })
                .find("at least the steepest slope of the table of 'strip', found 100000 N/m and "
                      "115000 N/m in the hoop direction"),
            std::string::npos);
  const auto weak = [](ShellConstants& c) { c.cloth.strength = {6500.0, 9200.0}; };
  EXPECT_NE(with(weak).find("found 6500 and 9200 N/m in the hoop direction: end the table at the "
                            "strength or write 'after_strength tear'"),
            std::string::npos);
  EXPECT_EQ(with([&](ShellConstants& c) {
              weak(c);
              c.cloth.after = AfterStrength::tear;
              c.cloth.fracture_energy = 100.0;
            }),
            "");
}

TEST(Cloth, RefusesToHardenMoreThanItUnloads)
{
  ShellConstants c = geotextile_of_table_3();
  c.cloth.strength = {4600.0, 4600.0};
  c.cloth.after = AfterStrength::yield;
  c.cloth.hardening = 115e3;
  EXPECT_NE(refusal_of(c).find("'hardening' must be less than 'modulus' times 'thickness', found "
                               "115000 and 115000 N/m in the hoop direction"),
            std::string::npos);
}

TEST(Cloth, RefusesFacetsThatWouldSnapBack)
{
  ShellConstants c = geotextile_of_table_3();
  c.cloth.strength = {9200.0, 9200.0};
  c.cloth.after = AfterStrength::tear;
  c.cloth.fracture_energy = 100.0;
  const Cloth cloth = ShellMaterial(c).cloth();
  EXPECT_NO_THROW(cloth.require_no_snap_back({{0.27, 0.27}}));
  try {
    cloth.require_no_snap_back({{0.1, 0.28}});
    FAIL() << "not refused";
  } catch (const InputError& problem) {
    EXPECT_EQ(
        std::string(problem.what()),
        "facets of a cloth that tears must be narrower than 2 G_f J / N_u^2 = 0.271739 m in "
        "the axial direction, or they snap back, found 0.28 m: use shorter facets or a larger "
        "'fracture_energy'");
  }
}
