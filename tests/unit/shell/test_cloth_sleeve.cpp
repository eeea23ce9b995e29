// SPDX-License-Identifier: GPL-2.0-only
// Tubes and strips of a geotextile that yields and tears, as meshes.
#include "core/constants.h"
#include "shell/cylinder_mesh.h"
#include "shell/seam.h"
#include "shell/sleeve_state.h"
#include "shell_cases.h"
#include "support/shell_oracles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

using namespace encased_column;

namespace {

constexpr double cloth_stiffness = 115e3, cloth_tube_radius = 0.05;  // [N/m], [m]

ShellConstants cloth_of_115()
{
  ShellConstants c;
  c.modulus_hoop = cloth_stiffness / 0.002;
  c.poisson = 0.3;
  c.thickness = 0.002;
  c.bending_thickness = 0.0;
  c.density = 500.0;
  return c;
}

/// Loads until nothing yields any more.
double settled_energy(ShellModel& model)
{
  double energy = 0.0;
  for (int n = 0; n < 60; ++n) {
    model.clear_loads();
    energy = model.add_internal_loads(0, model.facets());
  }
  return energy;
}

/// Inner pressure [Pa] of a tube stretched by `hoop` and `axial`, its ends free: outward forces
/// over the growth of the polygon's volume with its radius.
double pressure_of_tube(ShellModel& model, double hoop, double axial, int around)
{
  std::vector<Vec3> x = model.reference();
  for (Vec3& p : x) p = Vec3((1.0 + hoop) * p.x(), (1.0 + hoop) * p.y(), (1.0 + axial) * p.z());
  model.set_state(x, model.rotation(), model.velocity(), model.angular_velocity());
  settled_energy(model);
  double inward = 0.0;
  for (int i = 0; i < model.nodes(); ++i)
    inward -= model.force(i).dot(Vec3(x[i].x(), x[i].y(), 0.0).normalized());
  const auto [low, high] = std::minmax_element(
      x.begin(), x.end(), [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  const double radius = cloth_tube_radius * (1.0 + hoop);
  return inward / (around * radius * std::sin(2.0 * pi / around) * (high->z() - low->z()));
}

}  // namespace

// p = N / (R0 (1 + e)), N per length of the tube without load; it shortens by nu N / J.
TEST(ClothTube, UnderPressureFollowsTheClosedFormBeforeAndAfterItYields)
{
  const TubeShape shape{cloth_tube_radius, 0.0, 0.03, 0.005};
  const int around = 63;
  for (const double poisson : {0.0, 0.3})
    for (const double strength : {4600.0, 1e6}) {
      ShellConstants c = cloth_of_115();
      c.poisson = poisson;
      c.cloth.strength = {strength, 1e6};
      c.cloth.after = AfterStrength::yield;
      ShellModel tube(cylinder_mesh(shape), c, Vec3::UnitZ());
      for (const double e : {0.02, 0.04, 0.06, 0.08, 0.12}) {
        const double tension = std::min(cloth_stiffness * e, strength);
        const double axial = -poisson * tension / cloth_stiffness;
        const double p = pressure_of_tube(tube, e, axial, around) * std::cos(pi / around);
        const double expected = tension / (cloth_tube_radius * (1.0 + e) * (1.0 + axial));
        EXPECT_NEAR(p / expected, 1.0, 2e-3) << e << " " << poisson;
        if (e == 0.08 && poisson == 0.0 && strength == 1e6) {
          EXPECT_NEAR(p, 170.4e3, 2e-3 * 170.4e3);
        }
      }
    }
}

// In batches, with every kind of law and any memory, as one by one.
TEST(ClothBatches, GiveTheLoadsOfEachFacet)
{
  for (const bool bends : {false, true})
    for (const bool wrinkles : {false, true})
      for (const bool orthotropic : {false, true}) {
        ShellConstants c = orthotropic ? orthotropic_shell() : isotropic_shell();
        c.thickness = 0.002;
        c.bending_thickness = bends ? 0.002 : 0.0;
        c.tension_only = wrinkles;
        c.cloth.strength = {300.0, 200.0};
        c.cloth.after = AfterStrength::tear;
        c.cloth.fracture_energy = 1e3;
        const SurfaceMesh mesh = cylinder_mesh(TubeShape{0.05, 0.0, 0.06, 0.02});
        ShellModel model(mesh, c, Vec3::UnitZ());
        RandomVectors random(5);
        std::vector<Vec3> x = model.position();
        std::vector<Quaternion> q = model.rotation();
        for (Vec3& p : x) p = 1.2 * p + 0.002 * random();
        for (Quaternion& r : q) r = rotation_from_vector(0.1 * random());
        model.set_state(x, q, model.velocity(), model.angular_velocity());
        for (int n = 0; n < 3; ++n) {  // whole, then damaged
          std::vector<FacetMemory> memory;
          for (int f = 0; f < model.facets(); ++f) memory.push_back(model.memory(f));
          model.clear_loads();
          const double energy = model.add_internal_loads(0, model.facets(), true);
          double sum = 0.0;
          std::vector<Vec3> load(2 * model.nodes(), Vec3::Zero());
          for (int f = 0; f < model.facets(); ++f) {
            const FacetLoads loads = model.element()[f].loads(model.material(), model.corners(f),
                                                              model.corner_rotations(f), memory[f]);
            for (int i = 0; i < 3; ++i) {
              load[model.facet()[f][i]] += loads.force[i];
              load[model.nodes() + model.facet()[f][i]] += loads.moment[i];
            }
            sum += loads.energy;
          }
          EXPECT_NEAR(energy / sum, 1.0, 1e-12);
          double largest = 0.0, off = 0.0;
          for (std::size_t i = 0; i < load.size(); ++i) {
            largest = std::max(largest, load[i].norm());
            off = std::max(off, (load[i] - model.load()[i]).norm());
          }
          EXPECT_LT(off, 1e-12 * largest) << bends << wrinkles << orthotropic << n;
          // Asked for by the first, taken before the second.
          for (int again = 0; again < 2; ++again) model.add_internal_loads(0, model.facets());
        }
        EXPECT_GT(summary_of(model, HeightWindow()).damage_max, 0.0);
      }
}

// Whatever it remembers, any strain and bend: facets side by side as each one by ShellElement,
// which has no rows of numbers, limits or batches.
TEST(ClothBatches, GiveTheLoadsOfEachFacetWithAnyMemory)
{
  for (const bool wrinkles : {false, true})
    for (const bool orthotropic : {false, true}) {
      ShellConstants c = orthotropic ? orthotropic_shell() : isotropic_shell();
      c.thickness = c.bending_thickness = 0.002;
      c.tension_only = wrinkles;
      c.cloth.strength = {300.0, 200.0};
      c.cloth.after = AfterStrength::tear;
      c.cloth.fracture_energy = 1e3;
      ShellModel model(cylinder_mesh(TubeShape{0.05, 0.0, 0.06, 0.01}), c, Vec3::UnitZ());
      RandomVectors random(31);
      for (int n = 0; n < 10; ++n) {
        std::vector<Vec3> x = model.reference();
        std::vector<Quaternion> q = model.rotation();
        for (Vec3& p : x) p = (0.98 + 0.02 * n) * p + 0.002 * random();
        for (Quaternion& r : q) r = rotation_from_vector(0.3 * random());
        model.set_state(x, q, model.velocity(), model.angular_velocity());
        for (int f = 0; f < model.facets(); ++f) {
          const Vec3 some = random(), more = random();
          FacetMemory memory;
          memory.plastic_strain = {0.05 * std::abs(some.x()), 0.05 * std::abs(some.y())};
          if (f % 2 == 0) memory.damage = {std::abs(more.x()), std::abs(more.y())};
          if (f % 2 == 0) memory.slip = 0.05 * more.z();
          memory.most_shear = 0.1 * std::abs(some.z());
          model.cloth().set_memory(f, memory);
        }
        model.clear_loads();
        const double energy = model.add_internal_loads(0, model.facets(), true);
        double sum = 0.0;
        std::vector<Vec3> load(2 * model.nodes(), Vec3::Zero());
        for (int f = 0; f < model.facets(); ++f) {
          const FacetLoads loads = model.element()[f].loads(
              model.material(), model.corners(f), model.corner_rotations(f), model.memory(f));
          for (int i = 0; i < 3; ++i) {
            load[model.facet()[f][i]] += loads.force[i];
            load[model.nodes() + model.facet()[f][i]] += loads.moment[i];
          }
          sum += loads.energy;
        }
        EXPECT_NEAR(energy / sum, 1.0, 1e-12);
        double largest[2] = {0.0, 0.0}, off[2] = {0.0, 0.0};
        for (std::size_t i = 0; i < load.size(); ++i) {
          const int moment = static_cast<int>(i) / model.nodes();
          largest[moment] = std::max(largest[moment], load[i].norm());
          off[moment] = std::max(off[moment], (load[i] - model.load()[i]).norm());
        }
        for (const int moment : {0, 1}) EXPECT_LT(off[moment], 1e-12 * largest[moment]) << n;
      }
    }
}

// Half torn a facet bears half, moments too, and torn through nothing, however it is bent.
TEST(ClothBatches, LeaveATornFacetTheShareOfItsDamageInMembraneAndBending)
{
  for (const bool wrinkles : {false, true}) {
    ShellConstants c = isotropic_shell();
    c.tension_only = wrinkles;
    c.cloth.strength = {1e9, 1e9};
    c.cloth.after = AfterStrength::tear;
    c.cloth.fracture_energy = 1e15;
    ShellModel model(cylinder_mesh(TubeShape{0.05, 0.0, 0.06, 0.02}), c, Vec3::UnitZ());
    RandomVectors random(9);
    std::vector<Vec3> x = model.position();
    std::vector<Quaternion> q = model.rotation();
    for (Vec3& p : x) p += 0.002 * random();
    for (Quaternion& r : q) r = rotation_from_vector(0.1 * random());
    model.set_state(x, q, model.velocity(), model.angular_velocity());
    model.clear_loads();
    const double whole = model.add_internal_loads(0, model.facets(), true);
    const std::vector<Vec3> load = model.load();
    for (const double damage : {0.5, 1.0}) {
      for (int f = 0; f < model.facets(); ++f) {
        FacetMemory memory;
        memory.damage[f % 2] = damage;
        memory.most_shear = 1.0;
        model.cloth().set_memory(f, memory);
      }
      model.clear_loads();
      EXPECT_NEAR(model.add_internal_loads(0, model.facets(), true), (1.0 - damage) * whole,
                  1e-12 * whole);
      for (std::size_t i = 0; i < load.size(); ++i)
        EXPECT_LT((model.load()[i] - (1.0 - damage) * load[i]).norm(), 1e-9 * load[i].norm());
      const FacetState state = model.facet_state(3);
      if (damage == 1.0) {
        EXPECT_EQ(state.moment.norm(), 0.0);
        EXPECT_EQ(state.bending_energy + state.membrane_energy, 0.0);
      }
    }
  }
}

// At nodes that stand still what a tear dissipates is what its facets no longer store, bent and
// sheared as they are.
TEST(ClothBatches, DissipateWhatFacetsNoLongerStoreWhenTheyTear)
{
  ShellConstants c = cloth_of_115();
  c.bending_thickness = 0.002;
  c.cloth.strength = {2000.0, 2000.0};
  c.cloth.after = AfterStrength::tear;
  c.cloth.fracture_energy = 100.0;
  ShellModel model(cylinder_mesh(TubeShape{0.05, 0.0, 0.06, 0.01}), c, Vec3::UnitZ());
  RandomVectors random(4);
  std::vector<Vec3> x = model.position();
  std::vector<Quaternion> q = model.rotation();
  for (Vec3& p : x) p = 1.06 * p + 1e-4 * random();
  for (Quaternion& r : q) r = rotation_from_vector(0.5 * random());
  model.set_state(x, q, model.velocity(), model.angular_velocity());
  const double before = model.add_internal_loads(0, model.facets());
  double bending = 0.0;
  for (int f = 0; f < model.facets(); ++f) bending += model.facet_state(f).bending_energy;
  EXPECT_GT(bending, 0.05 * before);
  const double after = model.add_internal_loads(0, model.facets());
  EXPECT_LT(after, 0.8 * before);
  EXPECT_NEAR(model.cloth().dissipated(), before - after, 1e-10 * before);
}

// Over the corners of their tables, up to the strength and into the tear, side by side as each
// facet by Cloth::follow() alone; and a sleeve that takes their memory over goes on bit by bit.
TEST(ClothBatches, YieldAsFacetsOneByOneAndGoOnFromTheirMemory)
{
  for (const auto& [after, hardening] : {std::pair{AfterStrength::yield, 0.0},
                                         {AfterStrength::yield, 4.7e3},
                                         {AfterStrength::tear, 0.0}}) {
    ShellConstants c = cloth_of_115();
    c.tension_only = true;
    c.cloth.strip[0] = {{0.0, 0.0}, {0.02, 2300.0}, {0.03, 2800.0}, {0.06, 3400.0}};
    c.cloth.strip[1] = {{0.0, 0.0}, {0.01, 1150.0}, {0.05, 2000.0}};
    c.cloth.strength = {3600.0, 2100.0};
    c.cloth.after = after;
    c.cloth.hardening = hardening;
    c.cloth.fracture_energy = 100.0;
    ShellModel model(cylinder_mesh(TubeShape{0.05, 0.0, 0.06, 0.01}), c, Vec3::UnitZ());
    ShellModel other = model;
    std::vector<FacetMemory> memory(model.facets());
    std::vector<ClothFacet> facet(model.facets());
    for (int f = 0; f < model.facets(); ++f) facet[f].width = model.element()[f].tear_widths();
    RandomVectors random(11);
    std::vector<Vec3> off(model.nodes());
    for (Vec3& v : off) v = random();
    double taken = 0.0, largest = 0.0;
    const auto stretch = [&](ShellModel& sleeve, int step) {
      std::vector<Vec3> x = sleeve.reference();
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = (1.0 + 2e-4 * step) * x[i] + 2e-6 * step * off[i];
      sleeve.set_state(x, sleeve.rotation(), sleeve.velocity(), sleeve.angular_velocity());
      sleeve.clear_loads();
      sleeve.add_internal_loads(0, sleeve.facets());
    };
    for (int step = 0; step < 450; ++step) {
      stretch(model, step);
      for (int f = 0; f < model.facets(); ++f) {
        const FacetMemory found = model.memory(f);
        for (int i = 0; i < 2; ++i) {
          EXPECT_NEAR(found.plastic_strain[i], memory[f].plastic_strain[i], 1e-13);
          EXPECT_NEAR(found.damage[i], memory[f].damage[i], 1e-11);
        }
        const double area = model.element()[f].area();
        const FacetState state = model.facet_state(f);
        const PlaneVector force = model.material().membrane_force(state.strain, memory[f]);
        const PlaneVector elastic = ShellMaterial::elastic_strain(state.strain, memory[f]);
        largest = std::max(largest, memory[f].damage[0]);
        if (step == 449) continue;
        taken += area * model.material().cloth().follow(
                            {force, elastic(2), ShellMaterial::membrane_energy(elastic, force)},
                            facet[f], memory[f]);
      }
      if (step == 300) {  // half way, with the loads of the step before found again
        for (int f = 0; f < other.facets(); ++f) other.cloth().set_memory(f, model.memory(f));
        other.set_state(model.position(), model.rotation(), model.velocity(),
                        model.angular_velocity());
        other.clear_loads();
        other.add_internal_loads(0, other.facets(), true);
      } else if (step > 300) {
        stretch(other, step);
        for (std::size_t i = 0; i < model.load().size(); ++i)
          EXPECT_EQ(model.load()[i], other.load()[i]);
      }
    }
    EXPECT_NEAR(model.cloth().dissipated(), taken, 1e-11 * taken);
    EXPECT_GT(summary_of(model, HeightWindow()).plastic_hoop_strain_max, 0.02);
    EXPECT_EQ(largest > 0.1, after == AfterStrength::tear);
  }
}

// A set-up finds the same loads again and advances nothing.
TEST(ClothBatches, SetUpsChangeNothing)
{
  ShellConstants c = cloth_of_115();
  c.tension_only = true;
  c.cloth.strength = {500.0, 500.0};
  c.cloth.after = AfterStrength::yield;
  ShellModel once(cylinder_mesh(TubeShape{0.05, 0.0, 0.06, 0.02}), c, Vec3::UnitZ());
  std::vector<Vec3> x = once.position();
  for (Vec3& p : x) p *= 1.01;
  once.set_state(x, once.rotation(), once.velocity(), once.angular_velocity());
  ShellModel twice = once;
  for (int n = 0; n < 3; ++n) {
    for (ShellModel* model : {&once, &twice}) {
      model->clear_loads();
      model->add_internal_loads(0, model->facets());
    }
    twice.clear_loads();
    twice.add_internal_loads(0, twice.facets(), true);
    for (std::size_t i = 0; i < once.load().size(); ++i) EXPECT_EQ(once.load()[i], twice.load()[i]);
  }
  EXPECT_GT(once.memory(0).plastic_strain[0], 0.0);
  EXPECT_EQ(once.memory(0).plastic_strain, twice.memory(0).plastic_strain);
  EXPECT_EQ(once.cloth().dissipated(), twice.cloth().dissipated());
}

// Pulled slowly by its end, one row of facets a hundredth weaker: it parts there, and all that the
// strip takes is the fracture energy of its width, however short its elements are.
TEST(ClothStrip, TakesItsFractureEnergyWhateverItsMesh)
{
  const double length = 0.1, width = 0.02, fracture_energy = 100.0;
  for (const int elements : {4, 8, 16}) {
    SurfaceMesh mesh;
    for (int i = 0; i <= elements; ++i)
      for (const double z : {0.0, width}) mesh.node.push_back({i * length / elements, 0.0, z});
    for (int i = 0; i < elements; ++i) {
      mesh.facet.push_back({2 * i, 2 * i + 2, 2 * i + 1});
      mesh.facet.push_back({2 * i + 2, 2 * i + 3, 2 * i + 1});
    }
    ShellConstants c = cloth_of_115();
    c.cloth.strength = {9200.0, 9200.0};
    c.cloth.after = AfterStrength::tear;
    c.cloth.fracture_energy = fracture_energy;
    ShellModel model(mesh, c, Vec3::UnitZ());
    model.cloth().weaken({elements, elements + 1}, 0.99);
    std::vector<StiffnessBound> bound(model.nodes(), {0.0, 0.0});
    model.add_stiffness(0, model.facets(), bound);
    const double dt = model.stable_step(bound, 0.8);
    // To an opening beyond w_c, so slowly that the stored energy goes into the crack.
    const int steps = 4000 * elements;
    const double end = 1.2 * 2.0 * fracture_energy / 9200.0;
    for (const int node : {0, 1}) model.support().push_back(held_along(node, Vec3::UnitX()));
    for (const int node : {2 * elements, 2 * elements + 1}) {
      model.support().push_back(held_along(node, Vec3::UnitX()));
      model.support().back().velocity = Vec3(end / (steps * dt), 0.0, 0.0);
    }
    double work = 0.0, peak = 0.0, stored_at_peak = 0.0, work_at_peak = 0.0;
    for (int n = 0; n < steps; ++n) {
      model.clear_loads();
      const double stored = model.add_internal_loads(0, model.facets());
      work += model.advance(dt, 0.7).supports;
      const double pull = model.support()[2].force.x() + model.support()[3].force.x();
      if (pull > peak) peak = pull, stored_at_peak = stored, work_at_peak = work;
    }
    EXPECT_NEAR(peak / width, 0.99 * 9200.0, 0.01 * 9200.0);
    EXPECT_NEAR(model.cloth().dissipated() / width, fracture_energy, 0.02 * fracture_energy)
        << elements;
    EXPECT_NEAR((work - work_at_peak + stored_at_peak) / width, fracture_energy,
                0.02 * fracture_energy)
        << elements;
    for (int f = 0; f < model.facets(); ++f)
      EXPECT_EQ(model.memory(f).damage[0] > 0.0, f == elements || f == elements + 1) << f;
  }
}

// Across the line of the seam no facet is left that joins both sides.
TEST(Seam, PartsTheSleeveAlongItsLine)
{
  const SurfaceMesh mesh = cylinder_mesh(TubeShape{0.05, 0.0, 0.06, 0.01});
  for (const double angle : {0.0, 0.4, 3.0, -1.2}) {
    const std::vector<int> line = facets_on_line(mesh.facet, mesh.node, Vec3::Zero(), angle);
    const std::set<int> on_line(line.begin(), line.end());
    double low = 1.0, high = 0.0;
    for (std::size_t f = 0; f < mesh.facet.size(); ++f) {
      bool sides[2] = {false, false}, here = true;
      for (const int node : mesh.facet[f]) {
        const Vec3& x = mesh.node[node];
        const double turned = std::remainder(std::atan2(x.y(), x.x()) - angle, 2.0 * pi);
        here = here && std::abs(turned) < 0.5 * pi;
        // A node on the line itself may count to either side.
        if (turned > 1e-12) sides[1] = true;
        if (turned < -1e-12) sides[0] = true;
      }
      if (here && sides[0] && sides[1]) {
        EXPECT_EQ(on_line.count(static_cast<int>(f)), 1u) << f;
      }
    }
    for (const int f : line)
      for (const int node : mesh.facet[f]) {
        low = std::min(low, mesh.node[node].z());
        high = std::max(high, mesh.node[node].z());
        const Vec3& x = mesh.node[node];
        EXPECT_LT(std::abs(std::remainder(std::atan2(x.y(), x.x()) - angle, 2.0 * pi)), 0.21);
      }
    EXPECT_NEAR(low, 0.0, 1e-12);
    EXPECT_NEAR(high, 0.06, 1e-12);
  }
}
