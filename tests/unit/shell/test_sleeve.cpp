// SPDX-License-Identifier: GPL-2.0-only
// A sleeve as a whole, stepped without a host.
#include "shell/sleeve.h"

#include "core/constants.h"
#include "shell/cylinder_mesh.h"
#include "sleeve_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

constexpr double tube_radius = 0.05, tube_height = 0.06, tube_modulus = 11.5e6,
                 tube_thickness = 0.01;

ShellConstants cloth_constants()
{
  ShellConstants c;
  c.modulus_hoop = tube_modulus;
  c.poisson = 0.3;
  c.thickness = tube_thickness;
  c.density = 30.0;
  return c;
}

Sleeve cloth(const NodalMassRule& rule = {}, const ShellConstants& c = cloth_constants())
{
  return Sleeve(cylinder_mesh(TubeShape{tube_radius, 0.0, tube_height, 0.01}), c, rule);
}

SleeveControl with_ends(SleeveEnd top, SleeveEnd bottom)
{
  SleeveControl control;
  control.ends = {top, bottom};
  control.pressed_everywhere = true;
  return control;
}

/// The only rank.
struct Alone {
  void sum(double*, std::size_t) const {}
  void gather(const double*, const int*, const int*, double*) const {}
};

/// Steps of length 1, as with density scaling, with no grain or one.
class Stepper {
 public:
  explicit Stepper(Sleeve& sleeve, long step = 0) : sleeve_(sleeve), step_(step) {}

  void put_grain(const Vec3& center) { grain_ = center; }
  void set_up()
  {
    take_loads(true);
    sleeve_.find_reactions();
  }
  void run(int steps, double top_speed = 0.0, double bottom_speed = 0.0)
  {
    for (int n = 0; n < steps; ++n) {
      ++step_;
      sleeve_.advance(1.0, {top_speed, bottom_speed});
      take_loads(false);
    }
  }
  long step() const { return step_; }
  double push() const { return push_; }  ///< of the grain [N]
  const std::optional<GrainBehind>& behind() const { return behind_; }

 private:
  void take_loads(bool at_set_up)
  {
    const SleeveStep now{step_, 1.0};
    sleeve_.start_loads(now, HeightWindow(), at_set_up);
    sleeve_.list_grains(grain_.data(), &grain_radius_, grain_ == Vec3::Zero() ? 0 : 1, 0.001, true,
                        Alone());
    push_ = 0.0;
    behind_ = sleeve_.press_grains(
        SomeGrains{grain_.data(), {grain_radius_}}, [this](const SleeveContact& contact) {
          push_ = 1e5 * contact.merged.stiffening * contact.merged.overlap;
          return SleeveReaction{push_, -push_ * contact.merged.normal, Vec3::Zero(), 1e5};
        });
    sleeve_.finish_loads(now, Alone());
  }

  Sleeve& sleeve_;
  Vec3 grain_ = Vec3::Zero();
  double grain_radius_ = 0.01, push_ = 0.0;
  std::optional<GrainBehind> behind_;
  long step_;
};

}  // namespace

// Barlow's formula; the polygon of 31 sides is cos(pi / 31) narrower.
TEST(Sleeve, InflatedWithFreeEndsBearsPressureTimesRadius)
{
  Sleeve sleeve = cloth();
  sleeve.set_control(with_ends(SleeveEnd::free, SleeveEnd::free), 0);
  sleeve.set_pressure(-1e3, 100, 0);
  Stepper stepper(sleeve);
  stepper.set_up();
  stepper.run(2000);
  const SleeveSummary found = summary_of(sleeve.model(), HeightWindow());
  EXPECT_NEAR(found.hoop_tension, 1e3 * tube_radius, 0.01 * 1e3 * tube_radius);
  EXPECT_NEAR(found.hoop_strain, 1e3 * tube_radius / (tube_modulus * tube_thickness), 4e-6);
  // What the pressure did is stored or damped, and nothing moves any more.
  EXPECT_NEAR(sleeve.pressure_work(), sleeve.energy() + sleeve.damping_loss(),
              1e-3 * sleeve.pressure_work());
  EXPECT_LT(sleeve.model().kinetic_energy(), 1e-6 * sleeve.energy());
}

std::vector<int> nodes_at(const Sleeve& sleeve, double z)
{
  std::vector<int> nodes;
  for (int i = 0; i < sleeve.model().nodes(); ++i)
    if (std::abs(sleeve.model().reference()[i].z() - z) < 1e-9) nodes.push_back(i);
  return nodes;
}

TEST(Sleeve, EndsAreHeldAsTheirNamesSay)
{
  for (const auto& [end, moves_out, moves_along] :
       {std::tuple(SleeveEnd::held, false, false), std::tuple(SleeveEnd::clamped, false, false),
        std::tuple(SleeveEnd::radial, false, true), std::tuple(SleeveEnd::platen, false, true),
        std::tuple(SleeveEnd::free, true, true)}) {
    SCOPED_TRACE(sleeve_end_names()[static_cast<int>(end)]);
    Sleeve sleeve = cloth();
    sleeve.set_control(with_ends(end, SleeveEnd::held), 0);
    sleeve.set_pressure(-1e4, 1, 0);
    Stepper stepper(sleeve);
    stepper.set_up();
    stepper.run(200, 1e-6);
    for (const int node : nodes_at(sleeve, tube_height)) {
      const Vec3 way = sleeve.model().position()[node] - sleeve.model().reference()[node];
      EXPECT_EQ(way.head<2>().norm() > 1e-9, moves_out);
      EXPECT_EQ(std::abs(way.z()) > 1e-9, moves_along);
      if (end == SleeveEnd::platen) {
        EXPECT_NEAR(way.z(), -200e-6, 1e-15);
      }
      const double turn = Quaternion::Identity().angularDistance(sleeve.model().rotation()[node]);
      EXPECT_EQ(turn > 1e-9, end != SleeveEnd::clamped);
    }
    for (const int node : nodes_at(sleeve, 0.0))
      EXPECT_EQ(sleeve.model().position()[node], sleeve.model().reference()[node]);
    if (end == SleeveEnd::free) {
      EXPECT_EQ(sleeve.axial_force(true), 0.0);
    }
  }
}

// What the platen puts in is stored or damped.
TEST(Sleeve, LowerPlatenCarriesItsEndUpwardsAndWorksOnIt)
{
  Sleeve sleeve = cloth();
  sleeve.set_control(with_ends(SleeveEnd::held, SleeveEnd::platen), 0);
  Stepper stepper(sleeve);
  stepper.set_up();
  stepper.run(200, 0.0, 1e-6);
  for (const int node : nodes_at(sleeve, 0.0))
    EXPECT_NEAR(sleeve.model().position()[node].z() - sleeve.model().reference()[node].z(), 200e-6,
                1e-15);
  stepper.run(800);
  EXPECT_GT(sleeve.support_work(), 0.0);
  EXPECT_NEAR(sleeve.support_work(), sleeve.energy() + sleeve.damping_loss(),
              0.01 * sleeve.support_work());
}

TEST(Sleeve, OfAMeshThatIsInsideOutEnclosesItsVolume)
{
  SurfaceMesh mesh = cylinder_mesh(TubeShape{tube_radius, 0.0, tube_height, 0.01});
  for (Facet& facet : mesh.facet) std::swap(facet[1], facet[2]);
  ShellConstants constants;
  constants.modulus_hoop = tube_modulus;
  constants.thickness = tube_thickness;
  constants.density = 30.0;
  const Sleeve sleeve(mesh, constants, {});
  const double volume = pi * tube_radius * tube_radius * tube_height;
  EXPECT_NEAR(sleeve.enclosed_volume(HeightWindow()), volume, 0.01 * volume);
}

TEST(Sleeve, ThatLiesIsRefused)
{
  SurfaceMesh mesh = cylinder_mesh(TubeShape{tube_radius, 0.0, tube_height, 0.01});
  for (Vec3& node : mesh.node) node = Vec3(node.z(), node.x(), node.y());
  ShellConstants constants;
  constants.modulus_hoop = tube_modulus;
  constants.thickness = tube_thickness;
  constants.density = 30.0;
  EXPECT_THROW(Sleeve(mesh, constants, {}), InputError);
}

TEST(Sleeve, CountsGrainsOutsideOfItsWallAndOfTheWindow)
{
  const Sleeve sleeve = cloth();
  const double centers[] = {0.0, 0.0, 0.03, 0.06, 0.0, 0.03, 0.0, 0.0, 0.055, 0.0, 0.0, 0.005};
  EXPECT_EQ(sleeve.count_outside(centers, 1, {0.01, 0.05}), 0);
  EXPECT_EQ(sleeve.count_outside(centers, 2, {0.01, 0.05}), 1);
  EXPECT_EQ(sleeve.count_outside(centers, 3, {0.01, 0.05}), 2);
  EXPECT_EQ(sleeve.count_outside(centers, 4, {0.01, 0.05}), 3);
}

TEST(Sleeve, WhileItIsRigidStandsStillUnderAnyLoad)
{
  Sleeve sleeve = cloth();
  SleeveControl control;
  control.rigid = true;
  sleeve.set_control(control, 0);
  Stepper stepper(sleeve);
  stepper.put_grain({0.042, 0.0, 0.03});
  stepper.set_up();
  stepper.run(100);
  EXPECT_GT(stepper.push(), 50.0);
  EXPECT_EQ(sleeve.model().position(), sleeve.model().reference());
}

// Its release finds masses that bear its own facets and the contact: from the state it has, and
// from that state in a restart file.
TEST(Sleeve, ReleasedFromAStateThatWasRigidIsAsTheOneThatWentOn)
{
  SleeveControl rigid, released;
  rigid.rigid = true;
  Sleeve went_on = cloth(), restored = cloth();
  went_on.set_control(rigid, 0);
  restored.set_control(rigid, 0);
  Stepper first(went_on), second(restored);
  first.put_grain({0.042, 0.0, 0.03});
  second.put_grain({0.042, 0.0, 0.03});
  first.set_up();
  restored.restore(went_on.state(went_on.pressure_work(), 0.0));
  for (Sleeve* sleeve : {&went_on, &restored}) sleeve->set_control(released, 0);
  for (Stepper* stepper : {&first, &second}) {
    stepper->set_up();
    stepper->run(130);
  }
  EXPECT_EQ(restored.model().position(), went_on.model().position());
  EXPECT_EQ(restored.model().mass(), went_on.model().mass());
  std::vector<StiffnessBound> facets(went_on.model().nodes(), {0.0, 0.0});
  went_on.model().add_stiffness(0, went_on.model().facets(), facets);
  for (int i = 0; i < went_on.model().nodes(); ++i)
    EXPECT_GE(went_on.model().mass()[i], 0.95 * facets[i].translation / (0.8 * 0.8));
}

TEST(Sleeve, GoesOnFromItsStateBitByBit)
{
  const SleeveControl control = with_ends(SleeveEnd::radial, SleeveEnd::held);
  Sleeve whole = cloth(), restored = cloth();
  whole.set_control(control, 0);
  restored.set_control(control, 0);
  whole.set_pressure(20e3, 500, 0);
  Stepper first(whole), second(restored, 230);
  first.put_grain({0.042, 0.0, 0.03});
  second.put_grain({0.042, 0.0, 0.03});
  first.set_up();
  first.run(230);
  restored.restore(whole.state(whole.pressure_work(), 0.0));
  second.set_up();
  EXPECT_EQ(second.push(), first.push());
  for (Stepper* stepper : {&first, &second}) stepper->run(170);
  EXPECT_EQ(restored.state(restored.pressure_work(), 0.0), whole.state(whole.pressure_work(), 0.0));
}

TEST(Sleeve, RefusesAStateThatIsCutOffOrOfAnotherMesh)
{
  Sleeve sleeve = cloth();
  std::vector<double> state = sleeve.state(0.0, 0.0);
  state.pop_back();
  EXPECT_THROW(sleeve.restore(state), InputError);
  state = sleeve.state(0.0, 0.0);
  state[0] += 1.0;
  EXPECT_THROW(sleeve.restore(state), InputError);
}

TEST(Sleeve, WithTrueMassesRefusesAStepThatIsTooLong)
{
  Sleeve sleeve = cloth({false, 0.8, 50});
  Stepper stepper(sleeve);
  EXPECT_THROW(stepper.set_up(), InputError);
}

TEST(Sleeve, SaysWhichGrainIsBehindWhichFacet)
{
  Sleeve sleeve = cloth();
  Stepper stepper(sleeve);
  stepper.put_grain({0.055, 0.0, 0.03});
  stepper.set_up();
  ASSERT_TRUE(stepper.behind());
  const std::string sentence = sleeve.sentence_of(*stepper.behind(), 17, "side", 4);
  EXPECT_EQ(sentence.find("grain 17 is on the wrong side of facet "), 0u) << sentence;
  EXPECT_NE(sentence.find("of sleeve 'side' at step 4, load more slowly"), std::string::npos);
}

TEST(Sleeve, WarnsOnceOfAPlatenBeyondItsEndAndOfItsStrength)
{
  ShellConstants c = cloth_constants();
  c.cloth.strength = {10.0, 1e4};
  Sleeve sleeve = cloth({}, c);
  sleeve.set_control(with_ends(SleeveEnd::free, SleeveEnd::free), 0);
  sleeve.set_pressure(-1e3, 1, 0);
  Stepper stepper(sleeve);
  stepper.set_up();
  stepper.run(1000);
  const HeightWindow window{0.0, tube_height + 0.01};
  const auto first = sleeve.warnings(window, "side", {"top", "bottom"}, stepper.step());
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0].find("platen 'top' stands 0.01"), 0u) << first[0];
  EXPECT_EQ(first[1].find("the hoop tension of sleeve 'side' is 50"), 0u) << first[1];
  EXPECT_NE(first[1].find("passes its 'strength' of 10 N/m"), std::string::npos) << first[1];
  EXPECT_TRUE(sleeve.warnings(window, "side", {"top", "bottom"}, stepper.step()).empty());
}

// It bears p = s N_u / (R0 (1 + e)) at e = s N_u / J; its polygon of 31 sides 1 / cos(pi / 31) of
// it. Hardly any bending, which would bridge the tear, and no contraction along the axis.
TEST(Sleeve, BurstsAtItsSeam)
{
  ShellConstants c = cloth_constants();
  c.poisson = 0.0;
  c.bending_thickness = 1e-3;
  c.cloth.strength = {9200.0, 9200.0};
  c.cloth.after = AfterStrength::tear;
  c.cloth.fracture_energy = 30.0;
  c.cloth.seam = 0.7;
  c.cloth.seam_angle = pi / 3.0;
  Sleeve sleeve = cloth({}, c);
  sleeve.set_control(with_ends(SleeveEnd::free, SleeveEnd::free), 0);
  const double tension = 0.7 * 9200.0, e = tension / (tube_modulus * tube_thickness);
  const double burst = tension / (tube_radius * (1.0 + e)) / std::cos(pi / 31.0);
  sleeve.set_pressure(-0.99 * burst, 3000, 0);
  Stepper stepper(sleeve);
  stepper.set_up();
  stepper.run(3500);
  EXPECT_EQ(summary_of(sleeve.model(), HeightWindow()).damage_max, 0.0);
  EXPECT_FALSE(sleeve.fault(stepper.step()));
  sleeve.set_pressure(-1.01 * burst, 100, stepper.step());
  for (int n = 0; n < 100 && !sleeve.fault(stepper.step()); ++n) stepper.run(50);
  const auto fault = sleeve.fault(stepper.step());
  ASSERT_TRUE(fault);
  EXPECT_NE(fault->find("is torn through by its hoop tension at height"), std::string::npos)
      << *fault;
  EXPECT_NE(fault->find("on the seam: the test ends here"), std::string::npos) << *fault;
  for (int f = 0; f < sleeve.model().facets(); ++f)
    if (sleeve.model().memory(f).damage[0] > 0.0) {
      Vec3 center = Vec3::Zero();  // without load: what is torn opens
      for (const int node : sleeve.model().facet()[f])
        center += sleeve.model().reference()[node] / 3.0;
      EXPECT_NEAR(std::atan2(center.y(), center.x()), pi / 3.0, pi / 31.0);
      EXPECT_LT(sleeve.model().strength_share(0, f), 1.0);
    }
  EXPECT_GT(sleeve.dissipated(), 0.0);
}
