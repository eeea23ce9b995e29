// SPDX-License-Identifier: GPL-2.0-only
#include "shell/shell_model.h"

#include "shell/cylinder_mesh.h"
#include "shell_cases.h"
#include "support/shell_oracles.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

SurfaceMesh small_tube()
{
  TubeShape shape;
  shape.radius = 0.05;
  shape.height = 0.06;
  shape.edge = 0.02;
  return cylinder_mesh(shape);
}

ShellConstants geotextile()
{
  ShellConstants c;
  c.modulus_hoop = 11.5e6;
  c.poisson = 0.3;
  c.thickness = 0.002;
  c.density = 500.0;
  return c;
}

/// Displaced, turned and moving at random, free in space.
ShellModel shaken_tube(double strain, double speed)
{
  ShellModel model(small_tube(), geotextile(), Vec3::UnitZ());
  RandomVectors random(17);
  auto x = model.position();
  auto q = model.rotation();
  auto v = model.velocity(), w = model.angular_velocity();
  for (int i = 0; i < model.nodes(); ++i) {
    x[i] += 0.02 * strain * random();
    q[i] = rotation_from_vector(strain * random());
    v[i] = speed * (random() + Vec3(0.5, 0.0, 0.0));
    w[i] = speed / 0.02 * random();
  }
  model.set_state(x, q, v, w);
  return model;
}

double stable_step(const ShellModel& model, double factor)
{
  std::vector<StiffnessBound> bound(model.nodes(), {0.0, 0.0});
  model.add_stiffness(0, model.facets(), bound);
  return model.stable_step(bound, factor);
}

double step(ShellModel& model, double dt, double alpha)
{
  model.clear_loads();
  const double energy = model.add_internal_loads(0, model.facets());
  model.advance(dt, alpha);
  return energy;
}

}  // namespace

TEST(ShellModel, MassIsThatOfTheSheet)
{
  const ShellModel model(small_tube(), geotextile(), Vec3::UnitZ());
  double mass = 0.0, area = 0.0;
  for (const double m : model.mass()) mass += m;
  for (const ShellElement& e : model.element()) area += e.area();
  EXPECT_NEAR(mass / (500.0 * 0.002 * area), 1.0, 1e-13);
}

TEST(ShellModel, LoadsOfTwoRangesOfFacetsAreThoseOfAll)
{
  ShellModel whole = shaken_tube(0.1, 0.0), parts = whole;
  const double energy = whole.add_internal_loads(0, whole.facets());
  const double sum = parts.add_internal_loads(0, 17) + parts.add_internal_loads(17, parts.facets());
  EXPECT_NEAR(sum / energy, 1.0, 1e-14);
  for (std::size_t i = 0; i < whole.load().size(); ++i)
    EXPECT_LT((whole.load()[i] - parts.load()[i]).norm(), 1e-13 * whole.load()[0].norm());
}

TEST(ShellModel, FacetsSideBySideLoadTheNodesAsOneByOne)
{
  ShellModel model = shaken_tube(0.3, 0.0);
  std::vector<Vec3> expected(2 * model.nodes(), Vec3::Zero());
  double energy = 0.0, largest = 0.0;
  for (int f = 0; f < model.facets(); ++f) {
    const FacetLoads loads =
        model.element()[f].loads(model.material(), model.corners(f), model.corner_rotations(f));
    for (int i = 0; i < 3; ++i) {
      expected[model.facet()[f][i]] += loads.force[i];
      expected[model.nodes() + model.facet()[f][i]] += loads.moment[i];
      largest = std::max(largest, loads.force[i].norm());
    }
    energy += loads.energy;
  }
  EXPECT_NEAR(model.add_internal_loads(0, model.facets()) / energy, 1.0, 1e-13);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_LT((model.load()[i] - expected[i]).norm(), 1e-13 * largest);
}

TEST(ShellModel, RigidTurnOfTheWholeTubeLoadsNoNode)
{
  ShellModel model(small_tube(), geotextile(), Vec3::UnitZ());
  const Quaternion turn = rotation_from_vector(Vec3(1.0, -2.0, 0.7));
  auto x = model.position();
  for (Vec3& p : x) p = turn * p + Vec3(1.0, 2.0, 3.0);
  model.set_state(x, std::vector<Quaternion>(model.nodes(), turn), model.velocity(),
                  model.angular_velocity());
  model.add_internal_loads(0, model.facets());
  for (const Vec3& load : model.load()) EXPECT_LT(load.norm(), 1e-10);  // E t edge = 460 N
}

TEST(ShellModel, FreeTubeKeepsBothMomentaToRoundOff)
{
  ShellModel model = shaken_tube(0.1, 1.0);
  const double dt = stable_step(model, 1.0);
  const Vec3 linear = linear_momentum(model), angular = angular_momentum(model);
  for (int i = 0; i < 5000; ++i) step(model, dt, 0.0);
  EXPECT_LT((linear_momentum(model) - linear).norm(), 1e-12 * linear.norm());
  EXPECT_LT((angular_momentum(model) - angular).norm(), 1e-11 * angular.norm());
}

TEST(ShellModel, GrowsWithoutBoundsOnlyBeyondTheStableStep)
{
  const auto grown = [](double factor) {
    ShellModel model = shaken_tube(1e-6, 0.0);
    const double dt = stable_step(model, factor);
    double energy = 0.0;
    for (int i = 0; i < 2000; ++i) energy = step(model, dt, 0.0);
    return !(energy < 1.0);
  };
  EXPECT_FALSE(grown(1.99));
  EXPECT_TRUE(grown(3.0));  // and the bound wastes less than a third of the step
}

TEST(ShellModel, ScaledMassesMakeTheWantedStepStable)
{
  ShellModel model = shaken_tube(0.0, 0.0);
  std::vector<StiffnessBound> bound(model.nodes(), {0.0, 0.0});
  model.add_stiffness(0, model.facets(), bound);
  const double dt = model.stable_step(bound, 1.0);
  model.scale_masses(bound, 10.0 * dt, 1.0);
  EXPECT_GT(model.mass_factor(), 50.0);
  EXPECT_LE(model.mass_factor(), 100.0 * (1.0 + 1e-12));
  EXPECT_NEAR(model.stable_step(bound, 1.0) / (10.0 * dt), 1.0, 1e-12);
}

TEST(ShellModel, ANodeThatGetsHeavierKeepsItsMomentum)
{
  ShellModel model = shaken_tube(0.02, 0.0);
  std::vector<StiffnessBound> bound(model.nodes(), {0.0, 0.0});
  model.add_stiffness(0, model.facets(), bound);
  const double dt = model.stable_step(bound, 1.0);
  for (int i = 0; i < 50; ++i) step(model, dt, 0.0);
  const Vec3 momentum = linear_momentum(model);
  const double energy = model.kinetic_energy();
  const double taken = model.scale_masses(bound, 10.0 * dt, 1.0);
  EXPECT_LT((linear_momentum(model) - momentum).norm(), 1e-12 * std::sqrt(energy));
  EXPECT_GT(taken, 0.9 * energy);
  EXPECT_NEAR(model.kinetic_energy() + taken, energy, 1e-12 * energy);
}

TEST(ShellModel, LocalDampingBringsAShakenTubeToRest)
{
  ShellModel model = shaken_tube(0.02, 0.0);
  const double dt = stable_step(model, 1.0);
  const double start = step(model, dt, 0.7);
  double end = 0.0;
  for (int i = 0; i < 20000; ++i) end = step(model, dt, 0.7);
  EXPECT_LT(end, 1e-6 * start);
}

TEST(ShellModel, LocalDampingLeavesASteadyMotionAlone)
{
  ShellModel model(small_tube(), geotextile(), Vec3::UnitZ());
  std::vector<Vec3> drift(model.nodes(), Vec3(1.0, 0.0, 0.0));
  model.set_state(model.position(), model.rotation(), drift, model.angular_velocity());
  const double dt = stable_step(model, 1.0);
  for (int i = 0; i < 1000; ++i) step(model, dt, 0.7);
  for (const Vec3& v : model.velocity()) EXPECT_NEAR(v.x(), 1.0, 1e-9);
}

TEST(Support, HeldAndClampedNodesStayAndTheirForcesBalanceTheLoad)
{
  ShellModel model(small_tube(), geotextile(), Vec3::UnitZ());
  for (int i = 0; i < 16; ++i) model.support().push_back(clamped(i));
  const double dt = stable_step(model, 1.0);
  const int top = model.nodes() - 1;
  const Vec3 load(0.0, 0.0, 0.05);
  for (int i = 0; i < 30000; ++i) {
    model.clear_loads();
    model.add_internal_loads(0, model.facets());
    model.force(top) += load;
    model.advance(dt, 0.7);
  }
  Vec3 held_back = Vec3::Zero();
  for (const Support& s : model.support()) {
    EXPECT_EQ((model.position()[s.node] - model.reference()[s.node]).norm(), 0.0);
    EXPECT_EQ(rotation_vector(model.rotation()[s.node]).norm(), 0.0);
    held_back += s.force;
  }
  EXPECT_LT((held_back + load).norm(), 1e-6 * load.norm());
  EXPECT_GT(model.position()[top].z() - model.reference()[top].z(), 0.0);
}

TEST(Support, MovesANodeWithItsPlatenAndLeavesTheOtherDirectionsFree)
{
  ShellModel model(small_tube(), geotextile(), Vec3::UnitZ());
  Support slide = held_along(3, Vec3::UnitZ());
  slide.velocity = Vec3(0.0, 0.0, -0.01);
  model.support() = {slide, held_across(5, Vec3::UnitZ()), in_symmetry_plane(7, Vec3::UnitX())};
  for (const int node : {3, 5, 7}) {
    model.force(node) = Vec3(1.0, 1.0, 1.0);
    model.moment(node) = Vec3(1.0, 1.0, 1.0);
  }
  model.advance(1e-6, 0.0);
  const double speed = 1e-6 / model.mass()[3];
  EXPECT_NEAR((model.velocity()[3] - Vec3(speed, speed, -0.01)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((model.velocity()[5] - Vec3(0.0, 0.0, speed)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((model.velocity()[7] - Vec3(0.0, speed, speed)).norm(), 0.0, 1e-14);
  EXPECT_EQ(model.angular_velocity()[7].tail<2>().norm(), 0.0);
  EXPECT_GT(model.angular_velocity()[7].x(), 0.0);
  EXPECT_EQ(model.support()[0].force, Vec3(0.0, 0.0, -1.0));
}
