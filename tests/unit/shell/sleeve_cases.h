// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/constants.h"
#include "shell/cylinder_mesh.h"
#include "shell/sleeve_contacts.h"
#include "shell_cases.h"

namespace encased_column {

/// A short tube of 50 mm radius about the z axis, outward facets of about 20 mm.
inline ShellModel short_tube(double poisson = 0.3, bool tension_only = false)
{
  TubeShape shape;
  shape.radius = 0.05;
  shape.height = 0.06;
  shape.edge = 0.02;
  ShellConstants c;
  c.modulus_hoop = 11.5e6;
  c.poisson = poisson;
  c.thickness = 0.002;
  c.density = 500.0;
  c.tension_only = tension_only;
  return ShellModel(cylinder_mesh(shape), c, Vec3::UnitZ());
}

inline void place(ShellModel& model, const std::vector<Vec3>& position)
{
  model.set_state(position, model.rotation(), model.velocity(), model.angular_velocity());
}

/// The same with every node put out of place by up to `amount` [m] along each axis.
inline ShellModel crumpled_tube(double amount)
{
  ShellModel model = short_tube();
  RandomVectors random(29);
  std::vector<Vec3> x = model.position();
  for (Vec3& p : x) p += amount * random();
  place(model, x);
  return model;
}

/// Energy [J] of a touch whose facets have the stiffness `k` [N/m].
inline double energy_of(const MergedContact& touch, double k)
{
  return 0.5 * k * touch.stiffening * touch.overlap * touch.overlap;
}

/// A sphere and one facet that overlap.
struct FacetTouch {
  Vec3 direction;  ///< unit, from the center to the nearest point
  double overlap;  ///< [m]
  double pull = 0.0, share = 0.0;
};

/// The one contact that all of them make; sets their pulls and shares.
inline MergedContact merge_touches(std::vector<FacetTouch>& touches)
{
  TouchSum sum{0.0};
  for (const FacetTouch& t : touches) sum.deepest = std::max(sum.deepest, t.overlap);
  for (FacetTouch& t : touches) t.pull = t.share = sum.add(t.overlap / sum.deepest, t.direction);
  const JoinedTouches all = joined(sum);
  for (FacetTouch& t : touches) t.pull *= all.pull, t.share *= all.share;
  return all.contact;
}

/// Grains of one radius.
struct SomeGrains {
  const double* centers;
  std::vector<double> radii;

  bool counts(int) const { return true; }
  void fetch(int, int) const {}
};

/// What one grain at `center` did, or that it is behind the sleeve.
struct Seen {
  bool touches = false, behind = false;
  MergedContact merged{};
  SurfaceMotion surface;
};

/// Lists one grain of `radius` [m] and lets it press by `law`, a SleeveReaction of a SleeveContact.
template <typename Law>
Seen press_one(ShellModel& model, const Vec3& center, double radius, const Law& law,
               std::vector<StiffnessBound>* bound = nullptr)
{
  SleeveContacts contacts;
  contacts.list(model, center.data(), &radius, 1, 0.001);
  Seen seen;
  const auto behind = contacts.resolve(model, true, SomeGrains{center.data(), {radius}}, bound,
                                       [&](const SleeveContact& contact) {
                                         seen.touches = true;
                                         seen.merged = contact.merged;
                                         seen.surface = contact.surface;
                                         return law(contact);
                                       });
  seen.behind = behind.has_value();
  return seen;
}

inline SleeveReaction no_reaction(const SleeveContact&)
{
  return {0.0, Vec3::Zero(), Vec3::Zero(), 0.0};
}

}  // namespace encased_column
