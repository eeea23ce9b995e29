// SPDX-License-Identifier: GPL-2.0-only
#include "measure/measuring_sphere.h"

#include "core/constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>
#include <vector>

using namespace encased_column;

namespace {

struct Ball {
  Vec3 center;
  double radius;
};

/// Balls of 1 to 15 mm that do not overlap, placed one by one in a cube of 80 mm.
std::vector<Ball> packing_without_overlap(unsigned seed)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::vector<Ball> balls;
  for (int trial = 0; trial < 40000; ++trial) {
    // Large ones first: fines would leave no room for them.
    const double largest = trial < 4000 ? 7.5e-3 : 1.5e-3;
    const Ball ball{0.08 * Vec3(part(random), part(random), part(random)),
                    largest * (0.4 + 0.6 * part(random))};
    if (std::none_of(balls.begin(), balls.end(), [&](const Ball& other) {
          const double reach = other.radius + ball.radius;
          return (other.center - ball.center).squaredNorm() <= reach * reach;
        }))
      balls.push_back(ball);
  }
  return balls;
}

constexpr double spacing = 0.02, force = 3.0;  // m, N

/// Sums over a simple cubic lattice of touching spheres, each pressed by `force` at its six
/// contacts, in a ball about a point of it; the axis of the column is far away along -y.
SphereSums lattice_sums(const MeasuringSphere& ball)
{
  SphereSums sums;
  const int n = static_cast<int>(ball.radius / spacing) + 2;
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j)
      for (int k = -n; k <= n; ++k) {
        const Vec3 x = spacing * Vec3(i, j, k);
        add_grain(sums, ball, x, 0.5 * spacing, 6);
        for (int a = 0; a < 3; ++a)
          for (const double side : {1.0, -1.0}) {
            const Vec3 normal = side * Vec3::Unit(a);
            add_contact_end(sums, ball, x, -force * normal, 0.5 * spacing * normal);
            // each contact is met from both of its grains
            add_contact(sums, ball, x + 0.5 * spacing * normal, normal, 0.0, force, a == 2, 0.5);
          }
      }
  return sums;
}

}  // namespace

// Against points thrown into the ball: n of them hit solid with a deviation of 1 / (2 sqrt(n)).
TEST(MeasuringSphere, PorosityOfAPackingIsThatOfAMonteCarloEstimate)
{
  const std::vector<Ball> balls = packing_without_overlap(3);
  const MeasuringSphere sphere{Vec3(0.04, 0.045, 0.04), 0.03};
  SphereSums sums;
  for (const Ball& ball : balls) add_grain(sums, sphere, ball.center, ball.radius, 0);
  const double found = measure(sums, sphere).porosity;

  std::vector<Ball> near;
  std::copy_if(balls.begin(), balls.end(), std::back_inserter(near), [&](const Ball& ball) {
    return (ball.center - sphere.center).norm() < ball.radius + sphere.radius;
  });
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  const int wanted = 100000;
  int thrown = 0, empty = 0;
  while (thrown < wanted) {
    const Vec3 x = sphere.center + sphere.radius * Vec3(part(random), part(random), part(random));
    if (!sphere.holds(x)) continue;
    ++thrown;
    empty += std::none_of(near.begin(), near.end(), [&](const Ball& ball) {
      return (x - ball.center).squaredNorm() < ball.radius * ball.radius;
    });
  }
  EXPECT_LT(found, 0.8);
  EXPECT_NEAR(found, static_cast<double>(empty) / wanted, 4.0 * 0.5 / std::sqrt(wanted));
}

// A lattice's cell of side d holds one sphere: n = 1 - pi / 6, stress F d / d^3 in all directions.
// The ball's own porosity goes into its stress, and nothing else of where it stands.
TEST(MeasuringSphere, StressAndContactsOfASimpleCubicLatticeAreItsClosedForm)
{
  const double solid = pi / 6.0, stress = force / (spacing * spacing);
  for (const Vec3& center : {Vec3(0.0, 0.0, 0.0), Vec3(0.003, -0.006, 0.009)}) {
    const MeasuringSphere ball{center, 0.1};
    const SphereMeasure m = measure(lattice_sums(ball), ball);
    EXPECT_NEAR(m.porosity, 1.0 - solid, 0.01);
    EXPECT_EQ(m.coordination_number, 6.0);
    EXPECT_EQ(m.mechanical_coordination_number, 6.0);
    const Mat3 expected = stress * (1.0 - m.porosity) / solid * Mat3::Identity();
    EXPECT_LT((m.stress - expected).norm(), 1e-12 * stress);
    EXPECT_NEAR(m.axial, expected(0, 0), 1e-12 * stress);
    EXPECT_NEAR(m.radial, expected(0, 0), 1e-12 * stress);
    EXPECT_NEAR(m.hoop, expected(0, 0), 1e-12 * stress);
    EXPECT_NEAR(m.mean_force, force, 1e-12);
    EXPECT_NEAR(m.fabric.trace(), 1.0, 1e-12);
    EXPECT_NEAR(m.sliding_fraction, m.fabric(2, 2), 1e-12);  // those along z slide
    EXPECT_NEAR(m.fabric(2, 2), 1.0 / 3.0, 0.01);
  }
}

// Twelve contacts a grain, each pressed by F: with four grains in a cell of side a = sqrt(2) d,
// n = 1 - pi / (3 sqrt(2)) and sigma = (4 / a^3) 12 F (d / 2) / 3 = 4 sqrt(2) F / (2 d^2).
TEST(MeasuringSphere, StressAndContactsOfAFaceCentredLatticeAreItsClosedForm)
{
  const double cell = std::sqrt(2.0) * spacing, solid = pi / (3.0 * std::sqrt(2.0));
  const MeasuringSphere ball{Vec3(0.002, 0.001, -0.004), 0.1};
  std::vector<Vec3> normals;
  for (int a = 0; a < 3; ++a)
    for (const double one : {1.0, -1.0})
      for (const double other : {1.0, -1.0})
        normals.push_back((one * Vec3::Unit(a) + other * Vec3::Unit((a + 1) % 3)).normalized());
  SphereSums sums;
  const int n = static_cast<int>(2.0 * ball.radius / cell) + 2;
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j)
      for (int k = -n; k <= n; ++k) {
        if ((i + j + k) % 2 != 0) continue;
        const Vec3 x = 0.5 * cell * Vec3(i, j, k);
        add_grain(sums, ball, x, 0.5 * spacing, 12);
        for (const Vec3& normal : normals) {
          add_contact_end(sums, ball, x, -force * normal, 0.5 * spacing * normal);
          add_contact(sums, ball, x + 0.5 * spacing * normal, normal, 0.0, force, false, 0.5);
        }
      }
  const SphereMeasure m = measure(sums, ball);
  EXPECT_NEAR(m.porosity, 1.0 - solid, 0.01);
  EXPECT_EQ(m.coordination_number, 12.0);
  const double stress = 2.0 * std::sqrt(2.0) * force / (spacing * spacing);
  const Mat3 expected = stress * (1.0 - m.porosity) / solid * Mat3::Identity();
  EXPECT_LT((m.stress - expected).norm(), 1e-12 * stress);
  EXPECT_NEAR(m.mean_force, force, 1e-12);
}

// Balls so large that their surfaces are planes here: one holds what is left of x = 40 mm, the
// other what is right of it, a third all.
TEST(MeasuringSphere, SumsOverTheTwoHalvesOfAPackingAreThoseOverTheWhole)
{
  const double far = 1e4;
  const Vec3 middle(0.04, 0.04, 0.04), along = far * Vec3::UnitX();
  const MeasuringSphere left{middle - along, far}, right{middle + along, far}, all{middle, far};
  SphereSums halves, whole;
  for (const Ball& ball : packing_without_overlap(3)) {
    const Vec3 normal = (ball.center - Vec3(0.01, 0.02, 0.03)).normalized();
    const Vec3 pull = force * (normal + 0.1 * Vec3::UnitZ());
    for (auto [sums, spheres] :
         {std::pair(&halves, std::vector{left, right}), std::pair(&whole, std::vector{all})})
      for (const MeasuringSphere& sphere : spheres) {
        add_grain(*sums, sphere, ball.center, ball.radius, 1);
        add_contact_end(*sums, sphere, ball.center, -pull, ball.radius * normal);
        add_contact(*sums, sphere, ball.center + ball.radius * normal, normal, 1e-9, force, true,
                    1.0);
      }
  }
  EXPECT_GT(whole.grains, 100.0);
  EXPECT_EQ(halves.grains, whole.grains);
  EXPECT_EQ(halves.ends, whole.ends);
  EXPECT_EQ(halves.contacts, whole.contacts);
  EXPECT_EQ(halves.with_one_contact, whole.with_one_contact);
  for (double SphereSums::*sum : {&SphereSums::solid, &SphereSums::shared, &SphereSums::radial,
                                  &SphereSums::hoop, &SphereSums::force, &SphereSums::grain_volume})
    EXPECT_NEAR(halves.*sum, whole.*sum, 1e-5 * std::abs(whole.*sum));
  for (int n = 0; n < 9; ++n) {
    EXPECT_NEAR(halves.stress[n], whole.stress[n], 1e-9 * std::abs(whole.stress[8]));
    EXPECT_NEAR(halves.fabric[n], whole.fabric[n], 1e-9 * whole.contacts);
  }
}

// A grain on the x axis pressed along x only, then along y: radial there, then hoop.
TEST(MeasuringSphere, RadialAndHoopAreAboutTheAxis)
{
  const MeasuringSphere ball{Vec3(0.05, 0.01, 0.0), 0.02, Vec3(0.0, 0.01, 0.0)};
  const Vec3 x(0.05, 0.01, 0.0);
  for (int a = 0; a < 2; ++a) {
    SphereSums sums;
    add_grain(sums, ball, x, 0.005, 2);
    for (const double side : {1.0, -1.0})
      add_contact_end(sums, ball, x, -side * force * Vec3::Unit(a), side * 0.005 * Vec3::Unit(a));
    const SphereMeasure m = measure(sums, ball);
    EXPECT_GT(m.stress(a, a), 0.0);
    EXPECT_DOUBLE_EQ(a == 0 ? m.radial : m.hoop, m.stress(a, a));
    EXPECT_NEAR(a == 0 ? m.hoop : m.radial, 0.0, 1e-12 * m.stress(a, a));
  }
}

TEST(MeasuringSphere, CountsAGrainAcrossItsSurfaceByThePartInside)
{
  const MeasuringSphere ball{Vec3::Zero(), 0.04};
  SphereSums sums;
  add_grain(sums, ball, Vec3(0.045, 0.0, 0.0), 0.01, 3);
  EXPECT_GT(sums.solid, 0.0);
  EXPECT_EQ(sums.grains, 0.0);
  EXPECT_EQ(sums.ends, 0.0);
}

TEST(MeasuringSphere, OfNothingHasPorosityOneAndNoStress)
{
  const MeasuringSphere ball{Vec3::Zero(), 0.04};
  const SphereMeasure m = measure(SphereSums(), ball);
  EXPECT_EQ(m.porosity, 1.0);
  EXPECT_EQ(m.stress.norm() + m.fabric.norm() + m.sliding_fraction + m.mean_force, 0.0);
}
