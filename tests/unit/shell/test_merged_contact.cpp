// SPDX-License-Identifier: GPL-2.0-only
#include "shell/merged_contact.h"

#include "sleeve_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

constexpr double stiffness = 1e5;  // N/m, of one facet

/// A sphere against a crumpled tube; facets near it are listed again when it has moved by half the
/// margin of the list.
class RollingSphere {
 public:
  RollingSphere() : model_(crumpled_tube(0.002)) {}

  MergedContact touch(const Vec3& center)
  {
    if (!((center - listed_at_).norm() < 0.5 * margin)) {
      contacts_.list(model_, center.data(), &radius, 1, margin);
      listed_at_ = center;
    }
    MergedContact merged{};
    contacts_.resolve(model_, true, SomeGrains{center.data(), {radius}}, nullptr,
                      [&](const SleeveContact& contact) {
                        merged = contact.merged;
                        return no_reaction(contact);
                      });
    return merged;
  }
  double energy(const Vec3& center) { return energy_of(touch(center), stiffness); }
  Vec3 force(const Vec3& center)
  {
    const MergedContact t = touch(center);
    return -stiffness * t.stiffening * t.overlap * t.normal;
  }

 private:
  static constexpr double radius = 0.01, margin = 0.001;  // m

  ShellModel model_;
  SleeveContacts contacts_;
  Vec3 listed_at_ = Vec3::Constant(1.0);  // far away
};

/// A place on a path that winds along and round the tube, over facets, edges and nodes, with the
/// sphere some tenths of a millimetre deep.
Vec3 on_the_path(double s)
{
  const double angle = 2.0 * pi * s;
  return {0.0405 * std::cos(angle), 0.0405 * std::sin(angle), 0.03 + 0.015 * std::sin(5.0 * angle)};
}

}  // namespace

TEST(MergedContact, OfOneFacetIsTheOverlapItself)
{
  std::vector<FacetTouch> one{{Vec3::UnitZ(), 0.001}};
  const MergedContact touch = merge_touches(one);
  EXPECT_EQ(touch.overlap, 0.001);
  EXPECT_EQ(touch.stiffening, 1.0);
  EXPECT_EQ(touch.normal, Vec3(Vec3::UnitZ()));
  EXPECT_EQ(one[0].pull, 1.0);
  EXPECT_EQ(one[0].share, 1.0);
}

// Over an edge between two facets of one plane both have the overlap o. V = k (2^(1/8) o)^2 / 2:
// the energy is that of a spring 2^(1/4) as stiff at the overlap that the surface really has.
TEST(MergedContact, OfTwoEqualFacetsOfOnePlaneKeepsTheOverlapAndStiffensByTheFourthRootOfTwo)
{
  const FacetTouch touch{Vec3::UnitZ(), 0.001};
  std::vector<FacetTouch> two{touch, touch};
  const MergedContact joined = merge_touches(two);
  EXPECT_NEAR(joined.overlap / 0.001, 1.0, 1e-14);
  EXPECT_NEAR(joined.stiffening, std::pow(2.0, 0.25), 1e-14);
  const double largest = std::pow(2.0, 0.125) * 0.001;
  EXPECT_NEAR(energy_of(joined, 1.0), 0.5 * largest * largest, 1e-20);
  EXPECT_NEAR(two[0].share, 0.5, 1e-15);
  EXPECT_NEAR(two[1].pull, 0.5, 1e-15);
}

TEST(MergedContact, PullsOfAllFacetsAddUpToTheNormal)
{
  RandomVectors random(5);
  std::vector<FacetTouch> touches;
  for (int n = 0; n < 5; ++n)
    touches.push_back({(Vec3::UnitZ() + 0.3 * random()).normalized(), 1e-3 * (1.2 + random().x())});
  const MergedContact joined = merge_touches(touches);
  Vec3 sum = Vec3::Zero();
  double shares = 0.0;
  for (const FacetTouch& t : touches) {
    sum += t.pull * t.direction;
    shares += t.share;
  }
  EXPECT_LT((sum - joined.normal).norm(), 1e-14);
  EXPECT_NEAR(joined.normal.norm(), 1.0, 1e-14);
  EXPECT_NEAR(shares, 1.0, 1e-14);
}

TEST(MergedContact, AFacetThatIsOnlyJustTouchedChangesNothing)
{
  const FacetTouch deep{Vec3::UnitZ(), 0.001};
  std::vector<FacetTouch> two{deep, {Vec3::UnitX(), 1e-12}};
  const MergedContact joined = merge_touches(two);
  EXPECT_DOUBLE_EQ(joined.overlap, 0.001);
  EXPECT_LT((joined.normal - Vec3::UnitZ()).norm(), 1e-14);
}

TEST(RollingSphere, FeelsMinusTheGradientOfTheEnergyAlsoOverEdgesAndNodes)
{
  RollingSphere sphere;
  const double step = 1e-8;
  double deepest = 0.0;
  int joined = 0;
  for (double s = 0.0; s < 1.0; s += 0.003) {
    const Vec3 x = on_the_path(s), force = sphere.force(x);
    const MergedContact touch = sphere.touch(x);
    deepest = std::max(deepest, touch.overlap);
    if (touch.stiffening > 1.05) ++joined;
    for (int a = 0; a < 3; ++a) {
      const Vec3 aside = step * Vec3::Unit(a);
      const double slope = (sphere.energy(x + aside) - sphere.energy(x - aside)) / (2.0 * step);
      EXPECT_NEAR(force(a), -slope, 1e-6 * stiffness * 0.001) << "at " << s << " along " << a;
    }
  }
  EXPECT_GT(deepest, 1e-3);
  EXPECT_GT(joined, 30) << "the path passes edges";
}

// On the deepest facet alone the force would turn by the angle between two facets at every edge,
// here up to 0.5 rad: by some 50 N.
TEST(RollingSphere, FeelsAForceWithoutJumps)
{
  RollingSphere sphere;
  const double step = 2e-6;  // of the path's length of some 0.5 m
  Vec3 before = sphere.force(on_the_path(0.0));
  double largest = 0.0;
  for (double s = step; s < 0.25; s += step) {
    const Vec3 now = sphere.force(on_the_path(s));
    largest = std::max(largest, (now - before).norm());
    before = now;
  }
  EXPECT_LT(largest, 1.0);
}
