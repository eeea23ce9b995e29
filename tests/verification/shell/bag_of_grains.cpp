// SPDX-License-Identifier: GPL-2.0-only
#include "bag_of_grains.h"

#include "core/constants.h"
#include "shell/cylinder_mesh.h"
#include "support/shell_oracles.h"

#include <algorithm>
#include <stdexcept>

namespace encased_column {

namespace {

/// 80 mm long, 40 mm in radius in the middle, 12 mm at the ends.
SurfaceMesh barrel()
{
  TubeShape shape;
  shape.radius = 0.04;
  shape.height = 0.08;
  shape.edge = 0.02;
  SurfaceMesh mesh = cylinder_mesh(shape);
  for (Vec3& p : mesh.node) p.head<2>() *= 0.3 + 0.7 * std::sin(pi * p.z() / shape.height);
  return mesh;
}

ShellConstants cloth()
{
  ShellConstants c;
  c.modulus_hoop = 5e6;
  c.poisson = 0.3;
  c.thickness = 0.002;
  c.density = 500.0;
  return c;
}

/// Kinetic energy of a body at a step, from its velocities half a step before and after.
double mixed(double inertia, const Vec3& before, const Vec3& after)
{
  return inertia / 6.0 * (before.squaredNorm() + before.dot(after) + after.squaredNorm());
}

}  // namespace

BagOfGrains::BagOfGrains(const ContactMaterial& material)
    : material_(material),
      model_(barrel(), cloth(), Vec3::UnitZ())
{
  const Vec3 place[grains] = {Vec3(0.015, 0.005, 0.03), Vec3(-0.015, 0.002, 0.032),
                              Vec3(0.002, 0.016, 0.055), Vec3(0.001, -0.016, 0.05)};
  const Vec3 speed[grains] = {Vec3(0.4, 0.3, -0.2), Vec3(-0.5, 0.2, 0.1), Vec3(0.1, 0.6, 0.3),
                              Vec3(0.2, -0.3, 0.1)};
  for (int i = 0; i < grains; ++i) {
    grain_[i] = {place[i],     speed[i],     20.0 * speed[(i + 1) % grains],
                 Vec3::Zero(), Vec3::Zero(), place[i]};
    sleeve_memory_[i][3] = -2.0;
    for (int j = 0; j < grains; ++j) pair_memory_[i][j][3] = -2.0;
  }
  // Every node as if a grain stood right on it.
  std::vector<StiffnessBound> bound(model_.nodes(), {0.0, 0.0});
  model_.add_stiffness(0, model_.facets(), bound);
  for (StiffnessBound& b : bound)
    b.translation += 2.0 * linear_stiffness(material_, radius, radius).normal;
  dt_ = model_.stable_step(bound, 0.8);
  list_again();
}

void BagOfGrains::list_again()
{
  std::array<Vec3, grains> center;
  std::array<double, grains> radii;
  radii.fill(radius);
  for (int i = 0; i < grains; ++i) center[i] = grain_[i].listed = grain_[i].x;
  contacts_.list(model_, center.front().data(), radii.data(), grains, margin);
}

void BagOfGrains::book(const ContactAction& action)
{
  stored_ += action.stored;
  losses_ += action.friction_loss + action.rolling_loss + action.dashpot_loss;
}

void BagOfGrains::press_sleeve()
{
  struct Bag {
    const double* centers;
    std::array<double, grains> radii;
    bool counts(int) const { return true; }
    void fetch(int, int) const {}
  };
  std::array<Vec3, grains> center;
  for (int i = 0; i < grains; ++i) center[i] = grain_[i].x;
  Bag bag{center.front().data(), {}};
  bag.radii.fill(radius);
  const auto behind = contacts_.resolve(
      model_, true, bag, nullptr, [this](const SleeveContact& contact) -> SleeveReaction {
        Grain& g = grain_[contact.grain];
        const Touch touch{contact.merged.overlap,
                          contact.merged.normal,
                          mass,
                          {radius, g.v, g.w},
                          {0.0, contact.surface.velocity, contact.surface.spin}};
        const ContactAction action =
            resolve_contact<true>(stiffened(material_, contact.merged), touch, dt_,
                                  static_cast<double>(step_), true, sleeve_memory_[contact.grain]);
        g.force += action.force;
        g.moment += action.moment_i;
        book(action);
        ++sleeve_contacts_;
        return {action.normal_force, action.force, action.moment_j, action.stiffness.normal};
      });
  if (behind) throw std::runtime_error("a grain left the bag");
}

void BagOfGrains::press_pairs()
{
  for (int i = 0; i < grains; ++i)
    for (int j = i + 1; j < grains; ++j) {
      Grain &a = grain_[i], &b = grain_[j];
      const Vec3 way = b.x - a.x;
      const double overlap = 2.0 * radius - way.norm();
      if (overlap <= 0.0) continue;
      const Touch touch{
          overlap, way.normalized(), 0.5 * mass, {radius, a.v, a.w}, {radius, b.v, b.w}};
      const ContactAction action = resolve_contact<true>(
          material_, touch, dt_, static_cast<double>(step_), true, pair_memory_[i][j]);
      a.force += action.force;
      b.force -= action.force;
      a.moment += action.moment_i;
      b.moment += action.moment_j;
      book(action);
    }
}

double BagOfGrains::step()
{
  bool stale = contacts_.is_stale(model_);
  for (Grain& g : grain_) {
    g.force = g.moment = Vec3::Zero();
    stale = stale || (g.x - g.listed).norm() > 0.5 * margin;
  }
  if (stale) list_again();
  model_.clear_loads();
  stored_ = model_.add_internal_loads(0, model_.facets());
  press_sleeve();
  press_pairs();

  double energy = stored_ + losses_;
  for (Grain& g : grain_) {
    const Vec3 v = g.v, w = g.w;
    g.v += dt_ / mass * g.force;
    g.w += dt_ / inertia * g.moment;
    g.x += dt_ * g.v;
    energy += mixed(mass, v, g.v) + mixed(inertia, w, g.w);
  }
  const std::vector<Vec3> v = model_.velocity(), w = model_.angular_velocity();
  model_.advance(dt_, 0.0);
  for (int i = 0; i < model_.nodes(); ++i)
    energy += mixed(model_.mass()[i], v[i], model_.velocity()[i]) +
              mixed(model_.inertia()[i], w[i], model_.angular_velocity()[i]);
  ++step_;
  return energy;
}

Vec3 BagOfGrains::linear_momentum() const
{
  Vec3 sum = encased_column::linear_momentum(model_);
  for (const Grain& g : grain_) sum += mass * g.v;
  return sum;
}

Vec3 BagOfGrains::angular_momentum() const
{
  Vec3 sum = encased_column::angular_momentum(model_);
  for (const Grain& g : grain_) sum += mass * g.x.cross(g.v) + inertia * g.w;
  return sum;
}

double BagOfGrains::momentum_size() const
{
  double sum = 0.0;
  for (const Grain& g : grain_) sum += mass * g.v.norm();
  return sum;
}

}  // namespace encased_column
