// SPDX-License-Identifier: GPL-2.0-only
#include "shell/cylinder_mesh.h"
#include "shell/shell_model.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <random>

using namespace encased_column;

namespace {

/// A small free tube, displaced, turned and moving at random.
ShellModel shaken_tube(double strain, double speed)
{
  TubeShape shape;
  shape.radius = 0.05;
  shape.height = 0.06;
  shape.edge = 0.02;
  ShellConstants c;
  c.modulus_hoop = 11.5e6;
  c.poisson = 0.3;
  c.thickness = 0.002;
  c.density = 500.0;
  ShellModel model(cylinder_mesh(shape), c, Vec3::UnitZ());
  std::mt19937 generator(17);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto random = [&] {
    return Vec3(uniform(generator), uniform(generator), uniform(generator));
  };
  auto x = model.position();
  auto q = model.rotation();
  auto v = model.velocity(), w = model.angular_velocity();
  for (int i = 0; i < model.nodes(); ++i) {
    x[i] += shape.edge * strain * random();
    q[i] = rotation_from_vector(strain * random());
    v[i] = speed * random();
    w[i] = speed / shape.edge * random();
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

double step(ShellModel& model, double dt)
{
  model.clear_loads();
  const double energy = model.add_internal_loads(0, model.facets());
  model.advance(dt, 0.0);
  return energy;
}

}  // namespace

// Velocities live between the steps, v(-) before and v(+) after: m (v(-)^2 + v(-) v(+) + v(+)^2) /
// 6 is their energy at the step. For a linear mode that turns by q per step the energies with v(-)
// v(+) and with the mean of squares are its action times sin q and 2 tan(q/2); what the integrator
// keeps when modes exchange energy is the action times q, which this mixture meets to fourth order.
TEST(FreeSleeve, EnergyDoesNotGrowOver100000StepsAtTheStableStep)
{
  for (const auto& [factor, tolerance] : {std::pair{1.0, 0.002}, {1.8, 0.02}}) {
    ShellModel model = shaken_tube(0.02, 0.2);
    const double dt = stable_step(model, factor);
    const int steps = 100000, windows = 10;
    std::array<double, 10> mean{};
    std::vector<Vec3> v(model.nodes()), w(model.nodes());
    for (int i = 0; i < steps; ++i) {
      v = model.velocity();
      w = model.angular_velocity();
      double total = model.kinetic_energy() / 3.0;
      total += step(model, dt);
      total += model.kinetic_energy() / 3.0;
      for (int n = 0; n < model.nodes(); ++n)
        total += (model.mass()[n] * v[n].dot(model.velocity()[n]) +
                  model.inertia()[n] * w[n].dot(model.angular_velocity()[n])) /
                 6.0;
      mean[i * windows / steps] += total * windows / steps;
    }
    std::printf(
        "free sleeve, factor %.1f: energy of the last 10000 of 100000 steps over the first %.5f\n",
        factor, mean[9] / mean[0]);
    for (const double m : mean) EXPECT_NEAR(m / mean[0], 1.0, tolerance) << "factor " << factor;
  }
}
