#include "shell/sleeve_contacts.h"

#include "shell/nearest_point.h"
#include "sleeve_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

constexpr double radius = 0.01;  // of the grains [m]

/// Centers of grains that touch the tube on its inside, over facets, edges and nodes.
std::vector<Vec3> grains_inside(int count)
{
  RandomVectors random(8);
  std::vector<Vec3> center;
  for (int n = 0; n < count; ++n) {
    const double angle = 2.0 * pi * n / count, depth = 0.039 + 0.0015 * random().x();
    center.emplace_back(depth * std::cos(angle), depth * std::sin(angle),
                        0.03 + 0.02 * random().y());
  }
  return center;
}

/// Lists one grain and looks whether it touches.
bool touches(SleeveContacts& contacts, const ShellModel& model, const Vec3& center)
{
  contacts.list(model, center.data(), &radius, 1, 0.001);
  return contacts.size() == 1 && contacts.touches(model, 0, center, radius);
}

/// Where and how a grain presses on the sleeve.
struct Push {
  double normal_force;
  Vec3 shear, moment, point;
};

Push push_of(const SmoothTouch& touch, const Vec3& center, RandomVectors& random)
{
  const Vec3 any = 50.0 * random();
  return {200.0, any - any.dot(touch.normal) * touch.normal, 0.2 * random(),
          center + (radius - 0.5 * touch.overlap) * touch.normal};
}

Vec3 nearest_point(const ShellModel& model, int f, const Vec3& x)
{
  const FacetVectors c = model.corners(f);
  const Vec3 w = nearest_on_triangle(c[0], c[1], c[2], x);
  return w(0) * c[0] + w(1) * c[1] + w(2) * c[2];
}

/// The deepest overlap with any facet [m], found without a list; below zero where none is.
double deepest_overlap(const ShellModel& model, const Vec3& center)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (int f = 0; f < model.facets(); ++f)
    nearest = std::min(nearest, (nearest_point(model, f, center) - center).norm());
  return radius - nearest;
}

}  // namespace

TEST(SleeveContacts, NodalForcesHaveTheForceAndTheMomentOfTheContact)
{
  ShellModel model = crumpled_tube(0.002);
  SleeveContacts contacts;
  RandomVectors random(9);
  int several = 0;
  for (const Vec3& center : grains_inside(60)) {
    if (!touches(contacts, model, center)) continue;
    const Push push = push_of(contacts.touch(), center, random);
    model.clear_loads();
    contacts.take_point(model, push.point);
    contacts.press(model, push.normal_force, push.shear, push.moment);
    if (contacts.touch().stiffening > 1.01) ++several;
    const Vec3 normal = push.normal_force * contacts.touch().normal;
    for (const Vec3& about : {Vec3(0.0, 0.0, 0.0), center, Vec3(1.0, -2.0, 3.0)}) {
      Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
      double largest_force = 0.0, largest_moment = 0.0;
      for (int i = 0; i < model.nodes(); ++i) {
        const Vec3 turn = (model.position()[i] - about).cross(model.force(i));
        force += model.force(i);
        moment += turn;
        largest_force = std::max(largest_force, model.force(i).norm());
        largest_moment = std::max(largest_moment, turn.norm());
      }
      const Vec3 expected =
          (center - about).cross(normal) + (push.point - about).cross(push.shear) + push.moment;
      EXPECT_LT((force - normal - push.shear).norm(), 1e-12 * largest_force);
      EXPECT_LT((moment - expected).norm(), 1e-12 * largest_moment);
    }
  }
  EXPECT_GT(several, 10) << "contacts with more than one facet";
}

TEST(SleeveContacts, NormalForcesOnTheNodesAreMinusTheGradientOfTheEnergy)
{
  const double stiffness = 1e5, step = 1e-8;
  ShellModel model = crumpled_tube(0.002);
  SleeveContacts contacts;
  int checked = 0;
  for (const Vec3& center : grains_inside(12)) {
    if (!touches(contacts, model, center)) continue;
    const SmoothTouch touch = contacts.touch();
    model.clear_loads();
    contacts.take_point(model, center);
    contacts.press(model, stiffness * touch.stiffening * touch.overlap, Vec3::Zero(), Vec3::Zero());
    const std::vector<Vec3> load = model.load(), start = model.position();
    const auto energy_at = [&](int node, const Vec3& shift) {
      std::vector<Vec3> x = start;
      x[node] += shift;
      place(model, x);
      contacts.look_at(model);
      return contacts.touches(model, 0, center, radius) ? energy_of(contacts.touch(), stiffness)
                                                        : 0.0;
    };
    for (int i = 0; i < model.nodes(); ++i)
      for (int a = 0; a < 3; ++a) {
        const Vec3 aside = step * Vec3::Unit(a);
        const double slope = (energy_at(i, aside) - energy_at(i, -aside)) / (2.0 * step);
        EXPECT_NEAR(load[i](a), -slope, 1e-6 * stiffness * 0.001);
        if (std::abs(slope) > 1.0) ++checked;
      }
    place(model, start);
  }
  EXPECT_GT(checked, 25);
}

TEST(SleeveContacts, SurfaceOfATurningTubeMovesAsARigidBody)
{
  ShellModel model = crumpled_tube(0.002);
  SleeveContacts contacts;
  RandomVectors random(14);
  const Vec3 speed(0.3, -0.1, 0.2), spin(1.0, 2.0, -3.0);
  std::vector<Vec3> velocity;
  for (const Vec3& x : model.position()) velocity.push_back(speed + spin.cross(x));
  model.set_state(model.position(), model.rotation(), velocity, model.angular_velocity());
  int several = 0;
  for (const Vec3& center : grains_inside(60)) {
    if (!touches(contacts, model, center)) continue;
    const Vec3 point = push_of(contacts.touch(), center, random).point;
    contacts.take_point(model, point);
    const SurfaceMotion found = contacts.surface_motion(model);
    EXPECT_LT((found.velocity - speed - spin.cross(point)).norm(), 1e-13);
    EXPECT_LT((found.spin - spin).norm(), 1e-12);
    if (contacts.touch().stiffening > 1.01) ++several;
  }
  EXPECT_GT(several, 10);
}

// Whatever the nodes do: else friction on a sleeve that shakes would make energy out of nothing.
TEST(SleeveContacts, PowerOfTheNodalForcesIsThatOfShearAndMomentOnTheSurface)
{
  ShellModel model = crumpled_tube(0.002);
  SleeveContacts contacts;
  RandomVectors random(15);
  for (const Vec3& center : grains_inside(60)) {
    std::vector<Vec3> velocity = model.velocity();
    for (Vec3& v : velocity) v = random();
    model.set_state(model.position(), model.rotation(), velocity, model.angular_velocity());
    if (!touches(contacts, model, center)) continue;
    const Push push = push_of(contacts.touch(), center, random);
    model.clear_loads();
    contacts.take_point(model, push.point);
    contacts.press(model, 0.0, push.shear, push.moment);
    double power = 0.0, size = 0.0;
    for (int i = 0; i < model.nodes(); ++i) {
      power += model.force(i).dot(velocity[i]);
      size += model.force(i).norm() * velocity[i].norm();
    }
    const SurfaceMotion surface = contacts.surface_motion(model);
    EXPECT_NEAR(power, push.shear.dot(surface.velocity) + push.moment.dot(surface.spin),
                1e-13 * size);
  }
}

TEST(SleeveContacts, KnowWhichSideOfTheSleeveAGrainIsOn)
{
  const ShellModel model = crumpled_tube(0.003);
  SleeveContacts contacts;
  RandomVectors random(10);
  for (int n = 0; n < 200; ++n) {
    const double angle = 0.1 * n, z = 0.03 + 0.02 * random().y();
    const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
    // Sagitta of a facet and the crumpling: 1 and 5 mm.
    if (touches(contacts, model, 0.0425 * out + z * Vec3::UnitZ())) {
      EXPECT_FALSE(contacts.is_behind(model));
    }
    if (touches(contacts, model, 0.0565 * out + z * Vec3::UnitZ())) {
      EXPECT_TRUE(contacts.is_behind(model));
    }
  }
}

// A fold towards the inside by more than a right angle: the direction to its edge points against
// the normal of one of its two facets, and yet the grain is in front.
TEST(SleeveContacts, AGrainAtASharpFoldIsNotBehindIt)
{
  SurfaceMesh mesh;
  const double half = 0.01, deep = 0.03;
  mesh.node = {Vec3(0.0, -0.02, 0.0), Vec3(0.0, 0.02, 0.0), Vec3(deep, 0.0, half),
               Vec3(deep, 0.0, -half)};
  mesh.facet = {{0, 1, 2}, {1, 0, 3}};
  ShellConstants c;
  c.modulus_hoop = 1e6;
  c.thickness = 0.001;
  c.density = 500.0;
  const ShellModel model(mesh, c, Vec3::UnitY());
  SleeveContacts contacts;
  // The grains are on the side of x < 0: both normals must point to x > 0 there.
  const bool outward = model.element()[0].normal().x() > 0.0;
  for (const double angle : {-1.2, -0.9, -0.3, 0.0, 0.3, 0.9, 1.2}) {
    const Vec3 center(-0.009 * std::cos(angle), 0.0, 0.009 * std::sin(angle));
    ASSERT_TRUE(touches(contacts, model, center));
    EXPECT_EQ(contacts.is_behind(model), !outward) << "at " << angle;
  }
}

TEST(SleeveContacts, AGrainWithItsCenterInTheSurfaceIsNoContactToGoOnWith)
{
  const ShellModel model = short_tube();
  SleeveContacts contacts;
  const FacetVectors corner = model.corners(5);
  const Vec3 inside = corner[0];
  ASSERT_TRUE(touches(contacts, model, inside));
  EXPECT_TRUE(contacts.is_behind(model));
}

TEST(SleeveContacts, TheListHoldsUntilSomethingMovedHalfTheMargin)
{
  ShellModel model = crumpled_tube(0.002);
  const std::vector<Vec3> listed = grains_inside(60);
  std::vector<double> radii(listed.size(), radius);
  const double margin = 0.004;
  SleeveContacts contacts;
  contacts.list(model, listed.front().data(), radii.data(), static_cast<int>(listed.size()),
                margin);
  RandomVectors random(11);
  const auto aside = [&]() -> Vec3 { return 0.499 * margin * random().normalized(); };
  std::vector<Vec3> x = model.position();
  for (Vec3& p : x) p += aside();
  place(model, x);
  EXPECT_FALSE(contacts.is_stale(model));
  std::vector<Vec3> center = listed;
  for (Vec3& c : center) c += aside();

  std::vector<double> overlap(center.size(), 0.0);
  contacts.look_at(model);
  for (int n = 0; n < contacts.size(); ++n)
    if (contacts.touches(model, n, center[contacts.grain(n)], radius))
      overlap[contacts.grain(n)] = contacts.touch().overlap;
  int touching = 0;
  for (std::size_t i = 0; i < center.size(); ++i) {
    const double deepest = deepest_overlap(model, center[i]);
    EXPECT_EQ(overlap[i] > 0.0, deepest > 0.0) << "grain " << i;
    if (deepest > 0.0) ++touching;
  }
  EXPECT_GT(touching, 20);
  EXPECT_LT(touching, 60);

  x[3] += 0.6 * margin * Vec3::UnitX();
  place(model, x);
  EXPECT_TRUE(contacts.is_stale(model));
}

// The bound of a node must not be smaller than what the contact adds to its stiffness.
TEST(SleeveContacts, StiffnessOfAContactIsSharedOutOnItsNodes)
{
  const ShellModel model = crumpled_tube(0.002);
  SleeveContacts contacts;
  ASSERT_TRUE(touches(contacts, model, Vec3(0.041, 0.0, 0.03)));
  std::vector<StiffnessBound> bound(model.nodes(), {0.0, 0.0});
  contacts.add_stiffness(model, 1000.0, bound);
  double sum = 0.0;
  for (const StiffnessBound& b : bound) {
    sum += b.translation;
    EXPECT_EQ(b.rotation, 0.0);
  }
  EXPECT_NEAR(sum, 2000.0, 1e-9);
}
