// SPDX-License-Identifier: GPL-2.0-only
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

template <typename Law>
Seen press(ShellModel& model, const Vec3& center, const Law& law,
           std::vector<StiffnessBound>* bound = nullptr)
{
  return press_one(model, center, radius, law, bound);
}

/// Where and how a grain presses on the sleeve.
struct Push {
  double normal_force;
  Vec3 shear, moment, point;

  SleeveReaction reaction(const MergedContact& merged) const
  {
    return {normal_force, -shear - normal_force * merged.normal, moment, 0.0};
  }
};

Push push_of(const MergedContact& touch, const Vec3& center, RandomVectors& random)
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
  RandomVectors random(9);
  int several = 0;
  for (const Vec3& center : grains_inside(60)) {
    model.clear_loads();
    Push push{};
    const Seen seen = press(model, center, [&](const SleeveContact& contact) {
      push = push_of(contact.merged, center, random);
      return push.reaction(contact.merged);
    });
    if (!seen.touches) continue;
    if (seen.merged.stiffening > 1.01) ++several;
    const Vec3 normal = push.normal_force * seen.merged.normal;
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
  int checked = 0;
  for (const Vec3& center : grains_inside(12)) {
    model.clear_loads();
    const Seen seen = press(model, center, [&](const SleeveContact& contact) -> SleeveReaction {
      const double force = stiffness * contact.merged.stiffening * contact.merged.overlap;
      return {force, -force * contact.merged.normal, Vec3::Zero(), 0.0};
    });
    if (!seen.touches) continue;
    const std::vector<Vec3> load = model.load(), start = model.position();
    const auto energy_at = [&](int node, const Vec3& shift) {
      std::vector<Vec3> x = start;
      x[node] += shift;
      place(model, x);
      const Seen moved = press(model, center, no_reaction);
      return moved.touches ? energy_of(moved.merged, stiffness) : 0.0;
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
  const Vec3 speed(0.3, -0.1, 0.2), spin(1.0, 2.0, -3.0);
  std::vector<Vec3> velocity;
  for (const Vec3& x : model.position()) velocity.push_back(speed + spin.cross(x));
  model.set_state(model.position(), model.rotation(), velocity, model.angular_velocity());
  int several = 0;
  for (const Vec3& center : grains_inside(60)) {
    const Seen seen = press(model, center, no_reaction);
    if (!seen.touches) continue;
    const Vec3 point = center + (radius - 0.5 * seen.merged.overlap) * seen.merged.normal;
    EXPECT_LT((seen.surface.velocity - speed - spin.cross(point)).norm(), 1e-13);
    EXPECT_LT((seen.surface.spin - spin).norm(), 1e-12);
    if (seen.merged.stiffening > 1.01) ++several;
  }
  EXPECT_GT(several, 10);
}

// To a batch of contacts the sleeve is a body with its center where the overlap ends.
TEST(SleeveContacts, BodyOfATurningTubeMovesAsARigidBody)
{
  ShellModel model = crumpled_tube(0.002);
  const Vec3 speed(0.3, -0.1, 0.2), spin(10.0, 20.0, -30.0);
  std::vector<Vec3> velocity;
  for (const Vec3& x : model.position()) velocity.push_back(speed + spin.cross(x));
  model.set_state(model.position(), model.rotation(), velocity, model.angular_velocity());
  int seen = 0;
  for (const Vec3& center : grains_inside(60))
    press(model, center, [&](const SleeveContact& contact) {
      const MergedContact& merged = contact.merged;
      const ContactBody body = contact.body();
      const Vec3 end = center + (radius - merged.overlap) * merged.normal;
      EXPECT_LT((body.velocity - speed - spin.cross(end)).norm(), 1e-12);
      EXPECT_EQ(body.radius, 0.0);
      if (merged.overlap > 1e-4) ++seen;
      return no_reaction(contact);
    });
  EXPECT_GT(seen, 10);
}

// More grains than a block has room for, at different heights: each presses on its own.
TEST(SleeveContacts, GrainsOfManyBlocksPressWithTheSumOfTheirForces)
{
  ShellModel model = crumpled_tube(0.002);
  std::vector<Vec3> center;
  for (int ring = 0; ring < 3; ++ring)
    for (const Vec3& c : grains_inside(60)) center.push_back(c + 0.005 * ring * Vec3::UnitZ());
  const std::vector<double> radii(center.size(), radius);
  SleeveContacts contacts;
  contacts.list(model, center.front().data(), radii.data(), static_cast<int>(center.size()), 0.001);
  RandomVectors random(21);
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  int calls = 0;
  std::vector<int> touching;
  model.clear_loads();
  const auto law = [&](const SleeveContact* contact, int count, SleeveReaction* reaction) {
    ++calls;
    ASSERT_LE(count, SleeveContacts::in_block);
    for (int c = 0; c < count; ++c) {
      const Vec3& x = center[contact[c].grain];
      const Push push = push_of(contact[c].merged, x, random);
      reaction[c] = push.reaction(contact[c].merged);
      force -= reaction[c].force;
      // The normal force goes through the center.
      moment += x.cross(push.normal_force * contact[c].merged.normal) +
                push.point.cross(push.shear) + push.moment;
      touching.push_back(contact[c].grain);
    }
  };
  ASSERT_FALSE(
      contacts.resolve(model, true, SomeGrains{center.front().data(), radii}, nullptr, law));
  std::vector<int> expected;
  for (std::size_t i = 0; i < center.size(); ++i)
    if (deepest_overlap(model, center[i]) > 0.0) expected.push_back(static_cast<int>(i));
  EXPECT_EQ(touching, expected) << "in the order of their numbers";
  EXPECT_GE(calls, 3);
  EXPECT_NEAR(contacts.vertical_force(), force.z(), 1e-12 * 200.0 * expected.size());
  for (int i = 0; i < model.nodes(); ++i) {
    force -= model.force(i);
    moment -= model.position()[i].cross(model.force(i));
  }
  EXPECT_LT(force.norm(), 1e-12 * 200.0 * expected.size());
  EXPECT_LT(moment.norm(), 1e-12 * 200.0 * expected.size());
}

// Whatever the nodes do: else friction on a sleeve that shakes would make energy out of nothing.
TEST(SleeveContacts, PowerOfTheNodalForcesIsThatOfShearAndMomentOnTheSurface)
{
  ShellModel model = crumpled_tube(0.002);
  RandomVectors random(15);
  for (const Vec3& center : grains_inside(60)) {
    std::vector<Vec3> velocity = model.velocity();
    for (Vec3& v : velocity) v = random();
    model.set_state(model.position(), model.rotation(), velocity, model.angular_velocity());
    model.clear_loads();
    Push push{};
    const Seen seen = press(model, center, [&](const SleeveContact& contact) {
      push = push_of(contact.merged, center, random);
      push.normal_force = 0.0;
      return push.reaction(contact.merged);
    });
    if (!seen.touches) continue;
    double power = 0.0, size = 0.0;
    for (int i = 0; i < model.nodes(); ++i) {
      power += model.force(i).dot(velocity[i]);
      size += model.force(i).norm() * velocity[i].norm();
    }
    EXPECT_NEAR(power, push.shear.dot(seen.surface.velocity) + push.moment.dot(seen.surface.spin),
                1e-13 * size);
  }
}

TEST(SleeveContacts, KnowWhichSideOfTheSleeveAGrainIsOn)
{
  ShellModel model = crumpled_tube(0.003);
  RandomVectors random(10);
  int outside = 0;
  for (int n = 0; n < 200; ++n) {
    const double angle = 0.1 * n, z = 0.03 + 0.02 * random().y();
    const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
    // Sagitta of a facet and the crumpling: 1 and 5 mm.
    EXPECT_FALSE(press(model, 0.0425 * out + z * Vec3::UnitZ(), no_reaction).behind);
    const Seen seen = press(model, 0.0565 * out + z * Vec3::UnitZ(), no_reaction);
    EXPECT_FALSE(seen.touches) << "a grain behind the sleeve is not resolved";
    if (seen.behind) ++outside;
  }
  EXPECT_GT(outside, 150);
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
  ShellModel model(mesh, c, Vec3::UnitY());
  // The grains are on the side of x < 0: both normals must point to x > 0 there.
  const bool outward = model.element()[0].normal().x() > 0.0;
  for (const double angle : {-1.2, -0.9, -0.3, 0.0, 0.3, 0.9, 1.2}) {
    const Vec3 center(-0.009 * std::cos(angle), 0.0, 0.009 * std::sin(angle));
    const Seen seen = press(model, center, no_reaction);
    ASSERT_TRUE(seen.touches || seen.behind);
    EXPECT_EQ(seen.behind, !outward) << "at " << angle;
  }
}

TEST(SleeveContacts, AGrainWithItsCenterInTheSurfaceIsNoContactToGoOnWith)
{
  ShellModel model = short_tube();
  EXPECT_TRUE(press(model, model.corners(5)[0], no_reaction).behind);
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
  contacts.resolve(model, true, SomeGrains{center.front().data(), radii}, nullptr,
                   [&](const SleeveContact& contact) {
                     overlap[contact.grain] = contact.merged.overlap;
                     return no_reaction(contact);
                   });
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

// A list is kept as long as the host keeps its own, until a grain has moved by half the margin or
// the sleeve's nodes have: in every step the facets of every contact are those that touch when all
// facets are looked at. First grains grow in a sleeve that stands, with a jump now and then, then
// the sleeve shakes and bulges with them, slowly, fast and back again; now and then the grains come
// in another order, as from another rank.
TEST(SleeveContacts, MissNoFacetWhileGrainsAndSleeveMove)
{
  ShellModel model = crumpled_tube(0.002);
  std::vector<Vec3> center = grains_inside(60);
  std::vector<double> radii;
  RandomVectors random(17);
  for (std::size_t i = 0; i < center.size(); ++i)
    radii.push_back(radius * (0.8 + 0.1 * random().x()));
  const double margin = 0.002;
  const int grains = static_cast<int>(center.size());
  std::vector<Vec3> listed;
  std::vector<double> listed_radii;
  SleeveContacts contacts;
  const auto list = [&] {
    contacts.list(model, center.front().data(), radii.data(), grains, margin);
    listed = center;
    listed_radii = radii;
  };
  list();
  std::vector<Vec3> start = center, still = model.position();
  int lists = 0, touching = 0, several = 0;
  for (int step = 0; step < 1500; ++step) {
    const bool grows = step < 500;
    const double speed = step % 100 < 80 ? 0.004 : 0.2;  // of the margin, in a step
    for (int i = 0; i < grains; ++i) {
      if (i % 3 == 0 && step % 7 != 0) continue;  // at rest while the sleeve comes closer
      center[i] += speed * margin * random() + 0.02 * (start[i] - center[i]);
      if (grows) radii[i] *= 1.0 + (step % 50 == 49 ? 2e-3 : 2e-4 * random().x());
    }
    if (!grows) {
      std::vector<Vec3> x = model.position();
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] += speed * margin * random() +
                0.05 * ((1.0 - 0.02 * std::sin(0.02 * step)) * still[i] - x[i]);
      place(model, x);
    }
    if (step % 311 == 310) {
      std::swap(center[1], center[40]);
      std::swap(start[1], start[40]);
      std::swap(radii[1], radii[40]);
      list();
    }
    bool is_stale = contacts.is_stale(model);
    for (int i = 0; i < grains; ++i)
      is_stale = is_stale || (center[i] - listed[i]).norm() + std::abs(radii[i] - listed_radii[i]) >
                                 0.5 * margin;
    if (is_stale) list(), ++lists;
    std::vector<MergedContact> found(grains, {0.0, Vec3::Zero(), 0.0});
    const auto behind = contacts.resolve(model, true, SomeGrains{center.front().data(), radii},
                                         nullptr, [&](const SleeveContact& contact) {
                                           found[contact.grain] = contact.merged;
                                           return no_reaction(contact);
                                         });
    ASSERT_FALSE(behind) << "at step " << step;
    for (int i = 0; i < grains; ++i) {
      std::vector<FacetTouch> touches;
      for (int f = 0; f < model.facets(); ++f) {
        const Vec3 way = nearest_point(model, f, center[i]) - center[i];
        const double distance = way.norm();
        if (distance < radii[i]) touches.push_back({way / distance, radii[i] - distance});
      }
      if (touches.empty()) {
        ASSERT_EQ(found[i].overlap, 0.0) << "grain " << i << " at step " << step;
        continue;
      }
      ++touching;
      if (touches.size() > 1) ++several;
      const MergedContact expected = merge_touches(touches);
      ASSERT_NEAR(found[i].overlap, expected.overlap, 1e-15) << "grain " << i << " at " << step;
      ASSERT_LT((found[i].normal - expected.normal).norm(), 1e-9)
          << "grain " << i << " at " << step;
    }
  }
  EXPECT_GT(several, 3000);
  EXPECT_GT(touching, several + 2000);
  EXPECT_GT(lists, 20);
  EXPECT_LT(lists, 700);
}

// The bound of a node must not be smaller than what the contact adds to its stiffness.
TEST(SleeveContacts, StiffnessOfAContactIsSharedOutOnItsNodes)
{
  ShellModel model = crumpled_tube(0.002);
  std::vector<StiffnessBound> bound(model.nodes(), {0.0, 0.0});
  const auto law = [](const SleeveContact&) -> SleeveReaction {
    return {0.0, Vec3::Zero(), Vec3::Zero(), 1000.0};
  };
  ASSERT_TRUE(press(model, Vec3(0.041, 0.0, 0.03), law, &bound).touches);
  double sum = 0.0;
  for (const StiffnessBound& b : bound) {
    sum += b.translation;
    EXPECT_EQ(b.rotation, 0.0);
  }
  EXPECT_NEAR(sum, 2000.0, 1e-9);
}

// Grains that no list knows of may come into the sleeve's reach, or be in it and go on. The oracle
// is a new list.
TEST(SleeveContacts, AddsFacetsOfGrainsWhoseReachGotWider)
{
  constexpr double skin = 0.001;
  ShellModel model = crumpled_tube(0.002);
  const std::vector<Vec3> start{Vec3(0.0410, 0.0, 0.030), Vec3(-0.0360, 0.0, 0.030),
                                Vec3(0.0, 0.0, 0.030), Vec3(0.0, -0.0405, 0.025)};
  const std::vector<Vec3> end{start[0], Vec3(-0.0409, 0.0, 0.031), Vec3(0.0, 0.0407, 0.028),
                              start[3]};
  const std::vector<double> still(12, 0.0), radii(4, radius);
  std::vector<Vec3> center = start;
  ReachAccount account;
  account.start({center.front().data(), still.data(), radii.data(), 4, 4},
                ReachRule{0.5 * skin, 0.2});
  const GrainReach reach(skin, &account);
  const auto touching = [&](SleeveContacts& contacts) {
    std::vector<std::pair<int, double>> found;
    contacts.resolve(model, true, SomeGrains{center.front().data(), radii}, nullptr,
                     [&](const SleeveContact& contact) {
                       found.emplace_back(contact.grain, contact.merged.overlap);
                       return no_reaction(contact);
                     });
    return found;
  };
  SleeveContacts contacts;
  contacts.list(model, center.front().data(), radii.data(), 4, reach);
  EXPECT_EQ(touching(contacts).size(), 2u);
  center = end;
  for (const int i : {1, 2}) account.set_reach(i, 1.1 * (end[i] - start[i]).norm());
  contacts.add_wider(model, center.front().data(), radii.data(), 4, reach);
  SleeveContacts anew;
  anew.list(model, center.front().data(), radii.data(), 4, skin);
  const auto expected = touching(anew);
  ASSERT_EQ(expected.size(), 4u);
  EXPECT_EQ(touching(contacts), expected);
  EXPECT_EQ(contacts.grains(), (std::vector<int>{0, 1, 2, 3}));
}

// Some grains come and go, and leave their reach again and again, while the sleeve shakes and is
// listed anew at other times than they are. The oracle looks at all facets.
TEST(SleeveContacts, MissNoGrainWhileReachesAreWidened)
{
  constexpr double skin = 0.002;
  ShellModel model = crumpled_tube(0.002);
  const std::vector<Vec3> still = model.position(), start = grains_inside(60);
  std::vector<Vec3> center = start, velocity(start.size(), Vec3::Zero()), listed;
  const std::vector<double> radii(start.size(), radius);
  const int grains = static_cast<int>(start.size());
  const ListedGrains all{center.front().data(), velocity.front().data(), radii.data(), grains,
                         grains};
  ReachAccount account;
  const GrainReach reach(skin, &account);
  SleeveContacts contacts;
  RandomVectors random(31);
  int of_host = 0, of_sleeve = 0, wider = 0, touching = 0;
  for (int step = 0; step < 1000; ++step) {
    for (int i = 0; i < grains; ++i) {
      const double out = i % 10 == 0 ? 0.85 + 0.15 * std::sin(0.05 * step + i) : 1.0;
      center[i] += 0.01 * skin * random() + 0.1 * (out * start[i] - center[i]);
    }
    std::vector<Vec3> x = model.position();
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] +=
          0.03 * skin * random() + 0.05 * ((1.0 - 0.02 * std::sin(0.02 * step)) * still[i] - x[i]);
    place(model, x);
    account.forget_wider();
    const ReachAccount::Answer answer =
        step % 40 == 0 ? ReachAccount::Answer::lists_end : account.look(all, listed.front().data());
    if (answer == ReachAccount::Answer::lists_end) {
      account.start(all, ReachRule{0.5 * skin, 0.2});
      listed = center;
      contacts.list(model, center.front().data(), radii.data(), grains, reach);
      ++of_host;
    } else if (contacts.is_stale(model)) {
      contacts.list(model, center.front().data(), radii.data(), grains, reach);
      ++of_sleeve;
    } else if (answer == ReachAccount::Answer::some_are_wider) {
      contacts.add_wider(model, center.front().data(), radii.data(), grains, reach);
      ++wider;
    }
    std::vector<double> overlap(grains, 0.0);
    ASSERT_FALSE(contacts.resolve(model, true, SomeGrains{center.front().data(), radii}, nullptr,
                                  [&](const SleeveContact& contact) {
                                    overlap[contact.grain] = contact.merged.overlap;
                                    return no_reaction(contact);
                                  }));
    for (int i = 0; i < grains; ++i) {
      const bool touches = deepest_overlap(model, center[i]) > 0.0;
      ASSERT_EQ(overlap[i] > 0.0, touches) << "grain " << i << " at step " << step;
      touching += touches;
    }
  }
  EXPECT_GT(touching, 10000);
  EXPECT_GT(wider, 20);
  EXPECT_GT(of_sleeve, 3);
  EXPECT_GT(of_host, 3);
}
