// SPDX-License-Identifier: GPL-2.0-only
#include "measure/sphere_sampler.h"

#include "core/input_error.h"
#include "core/keyword_table.h"
#include "measure/sphere_overlap.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

const KeywordTable sphere_keywords{{"sphere", 4, "m", "", true},
                                   {"stack", 2, "-", ""},
                                   {"platens", 2, "-", ""},
                                   {"axis", 2, "m", ""}};

SphereSampler sampler_of(const std::vector<std::string>& words)
{
  return SphereSampler(sphere_keywords.read(words));
}

/// What the spheres say of one grain and its contact with a grain across the upper border along x.
std::vector<SphereRow> measured_across_a_border(const std::vector<std::string>& spheres)
{
  SphereSampler sampler = sampler_of(spheres);
  sampler.start({Vec3::Zero(), Vec3::Ones(), {true, false, false}}, {0.0, 0.0});
  const Vec3 left(0.95, 0.5, 0.5), right(0.04, 0.5, 0.5);  // 0.09 apart
  for (const bool first : {true, false}) {
    const Vec3 normal = (first ? 1.0 : -1.0) * Vec3::UnitX();
    sampler.add(SeenContact{first ? left : right, 0.05, false, false, Vec3::Zero(), 0.05, normal,
                            -8.0 * normal, 0.045, 0.09, 0.5, false, 0.0});
  }
  sampler.add_grain(left, 0.05, 1);
  sampler.add_grain(right, 0.05, 1);
  return sampler.samples(7.0);
}

}  // namespace

TEST(SphereSampler, PlacesAStackFromPlatenToPlaten)
{
  SphereSampler sampler = sampler_of({"stack", "3", "0.02", "platens", "a", "b", "axis", "1", "2"});
  ASSERT_TRUE(sampler.has_stack());
  sampler.start({}, {-0.1, 0.3});
  const std::vector<SphereRow> rows = sampler.samples(0.0);
  ASSERT_EQ(rows.size(), 3u);
  const double heights[] = {-0.08, 0.1, 0.28};
  for (int n = 0; n < 3; ++n) {
    EXPECT_LT((rows[n].sphere.center - Vec3(1.0, 2.0, heights[n])).norm(), 1e-15);
    EXPECT_EQ(rows[n].number, n + 1);
  }
  SphereSampler single = sampler_of({"stack", "1", "0.02", "platens", "a", "b"});
  single.start({}, {-0.1, 0.3});
  EXPECT_DOUBLE_EQ(single.samples(0.0).front().sphere.center.z(), 0.1);
}

// A pair across the border of a periodic box, seen from either side of it: one contact of 8 N half
// way between two grains.
TEST(SphereSampler, SeesAPairAcrossABorderWholeFromBothSides)
{
  const auto rows =
      measured_across_a_border({"sphere", "0.995", "0.5", "0.5", "0.2", "sphere", "-0.005", "0.5",
                                "0.5", "0.2", "sphere", "0.5", "0.5", "0.5", "0.2"});
  for (int n = 0; n < 2; ++n) {
    const SphereMeasure& m = rows[n].measure;
    EXPECT_EQ(rows[n].step, 7.0);
    EXPECT_EQ(m.grains, 2.0);
    EXPECT_EQ(m.coordination_number, 1.0);
    EXPECT_EQ(m.mean_force, 8.0);
    EXPECT_EQ(rows[n].largest_force, 8.0);
    // V sigma = F times the branch, the grains' share of the sphere apart.
    const double grains = 2.0 * sphere_volume(0.05);
    EXPECT_NEAR(m.stress(0, 0), (1.0 - m.porosity) / grains * 8.0 * 0.09, 1e-9);
    EXPECT_NEAR(m.porosity, 1.0 - grains / sphere_volume(0.2), 1e-12);
  }
  EXPECT_EQ(rows[2].measure.grains, 0.0);
  EXPECT_EQ(rows[2].measure.porosity, 1.0);
}

TEST(SphereSampler, RefusesWhatIsNoSphere)
{
  const std::vector<std::pair<std::vector<std::string>, std::string>> table{
      {{"sphere", "0", "0", "0", "0"}, "must be larger than zero, found 0"},
      {{"stack", "3", "0.02"}, "'stack' and 'platens' go together"},
      {{"platens", "a", "b", "sphere", "0", "0", "0", "1"}, "'stack' and 'platens' go together"},
      {{"stack", "0", "0.02", "platens", "a", "b"}, "from 1 to 1000, found 0"},
      {{"stack", "1001", "0.02", "platens", "a", "b"}, "from 1 to 1000, found 1001"},
      {{"stack", "1.5", "0.02", "platens", "a", "b"}, "from 1 to 1000, found 1.5"},
      {{"axis", "0", "0"}, "needs 'sphere' or 'stack'"}};
  for (const auto& [words, says] : table) {
    std::string sentence;
    try {
      sampler_of(words);
    } catch (const InputError& problem) {
      sentence = problem.what();
    }
    EXPECT_NE(sentence.find(says), std::string::npos) << says << "\n" << sentence;
  }
}

// Spheres that stand still come first and do not move with the platens.
TEST(SphereSampler, PlacesTheStackBehindTheSpheresThatStandStill)
{
  SphereSampler sampler = sampler_of({"sphere", "3", "4", "5", "0.1", "stack", "2", "0.02",
                                      "platens", "a", "b", "axis", "1", "2"});
  sampler.start({}, {0.0, 1.0});
  const std::vector<SphereRow> rows = sampler.samples(0.0);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].sphere.center, Vec3(3.0, 4.0, 5.0));
  EXPECT_EQ(rows[0].sphere.axis, Vec3(1.0, 2.0, 0.0));
  EXPECT_DOUBLE_EQ(rows[1].sphere.center.z(), 0.02);
  EXPECT_DOUBLE_EQ(rows[2].sphere.center.z(), 0.98);
}

// Two grains of 0.05 in a sphere, one contact each to the other's side, pushed by 8 N and by 3 N: V
// sigma is the sum of F times the lever of each end that counts.
TEST(SphereSampler, CountsTheSecondEndOfAContactWhereItIsItsOwn)
{
  const Vec3 left(-0.045, 0.0, 0.0), right(0.045, 0.0, 0.0);
  const double grains = 2.0 * sphere_volume(0.05);
  for (const bool counts_j : {true, false}) {
    SphereSampler sampler = sampler_of({"sphere", "0", "0", "0", "0.2"});
    sampler.start({}, {});
    for (const double force : {8.0, 3.0})
      sampler.add(SeenContact{left, 0.05, false, counts_j, right, 0.05, Vec3::UnitX(),
                              -force * Vec3::UnitX(), 0.045, 0.09, 1.0, false, 0.0});
    sampler.add_grain(left, 0.05, 2);
    sampler.add_grain(right, 0.05, 2);
    const SphereRow row = sampler.samples(0.0).front();
    EXPECT_NEAR(row.measure.stress(0, 0),
                (1.0 - row.measure.porosity) / grains * 11.0 * (counts_j ? 0.09 : 0.045), 1e-9);
    EXPECT_EQ(row.largest_force, 8.0);
    EXPECT_EQ(row.measure.mean_force, 5.5);
  }
}

// A contact just outside of whose grains one is inside counts for the stress, not as the largest.
TEST(SphereSampler, BeginsEverySampleAtNothingAndKeepsToItsSphere)
{
  SphereSampler sampler = sampler_of({"sphere", "0", "0", "0", "0.1"});
  sampler.start({}, {});
  const SeenContact across_its_surface{Vec3(0.15, 0.0, 0.0),
                                       0.06,
                                       false,
                                       true,
                                       Vec3(0.05, 0.0, 0.0),
                                       0.06,
                                       -Vec3::UnitX(),
                                       9.0 * Vec3::UnitX(),
                                       0.04,
                                       0.1,
                                       1.0,
                                       false,
                                       0.0};
  sampler.add(across_its_surface);
  sampler.add_grain(Vec3(0.05, 0.0, 0.0), 0.06, 1);
  sampler.add_grain(Vec3(0.15, 0.0, 0.0), 0.06, 1);
  SphereRow row = sampler.samples(0.0).front();
  EXPECT_EQ(row.measure.grains, 1.0);
  EXPECT_GT(std::abs(row.measure.stress(0, 0)), 0.0);  // of the grain whose center is inside
  EXPECT_EQ(row.largest_force, 0.0);                   // the contact is at 0.11
  const double solid =
      sphere_overlap_volume(0.1, 0.06, 0.05) + sphere_overlap_volume(0.1, 0.06, 0.15);
  EXPECT_NEAR(row.measure.porosity, 1.0 - solid / sphere_volume(0.1), 1e-12);

  sampler.start({}, {});
  row = sampler.samples(1.0).front();
  EXPECT_EQ(row.measure.grains, 0.0);
  EXPECT_EQ(row.measure.porosity, 1.0);
  EXPECT_EQ(row.largest_force, 0.0);
}

TEST(SphereSampler, SaysTheAxisItTookWhereNoneWasGiven)
{
  const Options options =
      sphere_keywords.read(std::vector<std::string>{"sphere", "0", "0", "0", "1"});
  SphereSampler{options};
  EXPECT_EQ(options.understood(), "sphere 0 0 0 1, axis 0 0");
}
