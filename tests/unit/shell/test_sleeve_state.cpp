// SPDX-License-Identifier: GPL-2.0-only
#include "shell/sleeve_state.h"

#include "sleeve_cases.h"

#include <gtest/gtest.h>

#include <limits>

using namespace encased_column;

namespace {

constexpr double encasement_stiffness = 11.5e6 * 0.002;  // E t of the short tube [N/m]

void widen(ShellModel& model, double strain, double above = -1.0)
{
  std::vector<Vec3> x = model.reference();
  for (Vec3& p : x)
    if (p.z() > above) p.head<2>() *= 1.0 + strain;
  place(model, x);
}

/// Strain along the axis of the facets of a widened staggered ring: their tips stand out over the
/// chord of their base by the sagitta, which grows with the radius.
double strain_along_axis(const ShellModel& model, double strain)
{
  const int around = 16;
  const double sagitta = 0.05 * (1.0 - std::cos(pi / around)), rise = model.reference()[around].z();
  return std::hypot(rise, (1.0 + strain) * sagitta) / std::hypot(rise, sagitta) - 1.0;
}

std::string fault_of(const ShellModel& model, double limit)
{
  return fault_of_facets(model, 0, model.facets(), limit).value_or("");
}

}  // namespace

// Chords grow as the radius does: the hoop strain is exact on any mesh.
TEST(SleeveSummary, OfAWidenedTubeHasTheHoopTensionOfItsStrain)
{
  const double strain = 0.07;
  ShellModel model = short_tube(0.0);
  widen(model, strain);
  const SleeveSummary s = summary_of(model, HeightWindow());
  EXPECT_NEAR(s.hoop_strain, strain, 1e-13);
  EXPECT_NEAR(s.hoop_strain_max, strain, 1e-13);
  EXPECT_NEAR(s.hoop_tension / (encasement_stiffness * strain), 1.0, 1e-12);
  EXPECT_NEAR(s.hoop_tension_max / (encasement_stiffness * strain), 1.0, 1e-12);
}

TEST(SleeveSummary, WithPoissonsRatioHasThePlaneStressTension)
{
  const double strain = 0.07, poisson = 0.3;
  ShellModel model = short_tube(poisson);
  widen(model, strain);
  const double along = strain_along_axis(model, strain);
  ASSERT_GT(along, 1e-5);
  const double expected =
      encasement_stiffness / (1.0 - poisson * poisson) * (strain + poisson * along);
  EXPECT_NEAR(summary_of(model, HeightWindow()).hoop_tension / expected, 1.0, 1e-12);
}

TEST(SleeveSummary, MeansAreTakenInTheWindowAndTheLargestValuesEverywhere)
{
  ShellModel model = short_tube(0.0);
  widen(model, 0.05, 0.031);  // the upper half; the middle ring stays
  const SleeveSummary low = summary_of(model, {0.0, 0.0299});
  EXPECT_NEAR(low.hoop_strain, 0.0, 1e-12);
  EXPECT_GT(low.hoop_strain_max, 0.02);
  EXPECT_GT(low.hoop_tension_max, 0.02 * encasement_stiffness);
  const SleeveSummary none = summary_of(model, {1.0, 2.0});
  EXPECT_EQ(none.area, 0.0);
  EXPECT_EQ(none.hoop_tension, 0.0);
}

TEST(SleeveFault, OfASoundTubeIsNone)
{
  ShellModel model = crumpled_tube(0.001);
  EXPECT_EQ(fault_of(model, 0.5), "");
  SurfaceMesh mesh{model.reference(), model.facet()};
  EXPECT_FALSE(fault_of_pairs(model, facet_pairs(mesh)));
}

TEST(SleeveFault, NamesAFacetWithAPositionThatIsNoNumber)
{
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    ShellModel model = short_tube();
    std::vector<Vec3> x = model.position();
    x[model.facet()[7][1]].y() = bad;
    place(model, x);
    const std::string fault = fault_of(model, 0.5);
    EXPECT_NE(fault.find("has a position that is not a number"), std::string::npos) << fault;
  }
}

TEST(SleeveFault, NamesAFacetStrainedBeyondTheLimitEitherWay)
{
  ShellModel model = short_tube();
  widen(model, 0.3);
  EXPECT_EQ(fault_of(model, 0.31), "");
  EXPECT_NE(fault_of(model, 0.29).find("is strained by 0.3, the 'strain_limit' is 0.29"),
            std::string::npos)
      << fault_of(model, 0.29);
  widen(model, -0.3);
  EXPECT_EQ(fault_of(model, 0.31), "");
  EXPECT_NE(fault_of(model, 0.29), "");
}

TEST(SleeveFault, LooksAtItsOwnRangeOfFacetsOnly)
{
  ShellModel model = short_tube();
  widen(model, 0.3, 0.05);  // the upper end only
  EXPECT_FALSE(fault_of_facets(model, 0, 32, 0.1));
  EXPECT_TRUE(fault_of_facets(model, model.facets() - 1, model.facets(), 0.1));
}

TEST(SleeveFault, NamesTwoFacetsThatAreFoldedOnEachOther)
{
  ShellModel model = short_tube();
  const auto pairs = facet_pairs({model.reference(), model.facet()});
  const auto& [a, b] = pairs[pairs.size() / 2];
  // The tip of one facet goes over to the other side of the edge they share.
  int tip = -1;
  for (const int node : model.facet()[a])
    if (std::count(model.facet()[b].begin(), model.facet()[b].end(), node) == 0) tip = node;
  Vec3 middle = Vec3::Zero();
  for (const int node : model.facet()[a])
    if (node != tip) middle += 0.5 * model.position()[node];
  std::vector<Vec3> x = model.position();
  x[tip] = middle + 0.9 * (middle - x[tip]);
  place(model, x);
  const auto fault = fault_of_pairs(model, {{a, b}});
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->find("facets " + std::to_string(a) + " and " + std::to_string(b) +
                        " of the sleeve are folded on each other"),
            0u)
      << *fault;
}

TEST(FacetPairs, AreThoseThatShareAnEdgeEachOnce)
{
  const ShellModel model = short_tube();
  const auto pairs = facet_pairs({model.reference(), model.facet()});
  std::vector<std::array<int, 2>> expected;
  for (int a = 0; a < model.facets(); ++a)
    for (int b = a + 1; b < model.facets(); ++b) {
      int shared = 0;
      for (const int i : model.facet()[a])
        shared += std::count(model.facet()[b].begin(), model.facet()[b].end(), i);
      if (shared == 2) expected.push_back({a, b});
    }
  std::vector<std::array<int, 2>> found;
  for (const auto& [a, b] : pairs) found.push_back({std::min(a, b), std::max(a, b)});
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
  EXPECT_EQ(found.size(), (3u * model.facets() - 32u) / 2u) << "less the two ends of 16 edges";
}

// Shortened by 60 % along its axis a sleeve that wrinkles only folds.
TEST(FaultOfFacets, OfASleeveThatWrinklesIsStretchAlone)
{
  ShellModel bears = short_tube(0.3), wrinkles = short_tube(0.3, true);
  for (ShellModel* model : {&bears, &wrinkles}) {
    std::vector<Vec3> x = model->reference();
    for (Vec3& p : x) p.z() *= 0.4;
    place(*model, x);
  }
  EXPECT_NE(fault_of(bears, 0.5), "");
  EXPECT_EQ(fault_of(wrinkles, 0.5), "");
  widen(wrinkles, 0.6);
  EXPECT_NE(fault_of(wrinkles, 0.5), "");
}

TEST(FaultOfFacets, SoonAfterTheReleaseDoesNotAskForASlowerLoad)
{
  ShellModel model = short_tube(0.3);
  widen(model, 0.6);
  const auto at = [&](long released) {
    return *fault_of_facets(model, 0, model.facets(), 0.5, released);
  };
  EXPECT_NE(at(-1).find("slow the loading"), std::string::npos);
  EXPECT_NE(at(5000).find("slow the loading"), std::string::npos);
  EXPECT_EQ(at(200).find("slow the loading"), std::string::npos);
  EXPECT_NE(at(200).find("200 steps after its release"), std::string::npos);
  EXPECT_NE(at(200).find("pack them looser"), std::string::npos);
}
