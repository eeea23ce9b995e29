// SPDX-License-Identifier: GPL-2.0-only
#include "shell/sleeve_contacts.h"

#include "shell/height_bands.h"
#include "shell/nearest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace encased_column {

namespace {

/// Part of the margin by which grain and sleeve may move before all facets near by are looked at.
constexpr double look_again = 0.1;

/// Way from a point to the nearest one of a facet, which `weight` gets as area coordinates.
Vec3 way_to_facet(const FacetVectors& corner, const Vec3& from, Vec3& weight)
{
  weight = nearest_on_triangle(corner[0], corner[1], corner[2], from);
  return weight(0) * corner[0] + weight(1) * corner[1] + weight(2) * corner[2] - from;
}

}  // namespace

void SleeveContacts::list(const ShellModel& model, const double* centers, const double* radii,
                          int grains, double margin)
{
  margin_ = margin;
  listed_travel_ = model.travel();
  listed_position_ = model.position();
  grid_.sort(model.facet(), model.position());
  grain_.clear();
  near_.clear();
  facet_.clear();
  gap_.clear();
  const HeightBands bands(model.facet(), model.position());
  for (int i = 0; i < grains; ++i) {
    const Vec3 center = as_vec3(centers + 3 * i);
    const double reach = radii[i] + 1.5 * margin;
    if (bands.is_clear(center, reach)) continue;  // most grains
    Near near{i, static_cast<int>(facet_.size()), 0, reach, center, radii[i], listed_travel_};
    grid_.near(center, reach, [&](int f) {
      Vec3 weight;
      const double square = way_to_facet(model.corners(f), center, weight).squaredNorm();
      if (square >= reach * reach) return;
      facet_.push_back(f);
      gap_.push_back(std::sqrt(square) - radii[i]);
      near.clear = std::min(near.clear, gap_.back());
    });
    near.end = static_cast<int>(facet_.size());
    if (near.end == near.begin) continue;
    grain_.push_back(i);
    near_.push_back(near);
  }
}

bool SleeveContacts::is_stale(const ShellModel& model) const
{
  if (model.travel() - listed_travel_ <= 0.5 * margin_) return false;
  const double limit = 0.25 * margin_ * margin_;
  for (int i = 0; i < model.nodes(); ++i)
    if ((model.position()[i] - listed_position_[i]).squaredNorm() > limit) return true;
  return false;
}

// Most facets near by stay out of reach for hundreds of steps. A gap d seen after the grain has
// moved by m and the sleeve by s counts as one of d - m + s at the start: it closes no faster than
// both move on, and the grain may first move back.
bool SleeveContacts::touches(const ShellModel& model, Near& near, const Vec3& center, double radius)
{
  double closed = near.closed(model, center, radius);
  if (closed < near.clear) return false;
  const bool all = closed > look_again * margin_;
  if (all) {
    near.center = center, near.radius = radius, near.travel = model.travel();
    closed = 0.0;
  }
  const double moved = (center - near.center).norm();
  facets_.clear();
  near.clear = std::numeric_limits<double>::infinity();
  for (int m = near.begin; m < near.end; ++m) {
    if (all || !(gap_[m] > closed)) {
      const int f = facet_[m];
      Vec3 weight;
      const Vec3 way = way_to_facet(model.corners(f), center, weight);
      const double square = way.squaredNorm();
      const double distance = std::sqrt(square);
      gap_[m] = distance - radius + closed - 2.0 * moved;
      if (square < radius * radius)
        facets_.push_back({f, weight, way / distance, radius - distance, 0.0, 0.0});
    }
    near.clear = std::min(near.clear, gap_[m]);
  }
  if (facets_.empty()) return false;
  merged_ = merge_touches(facets_);
  return true;
}

// Over an edge or a node several facets are as deep. At a sharp fold the direction may point
// against the normal of one of them on the right side too: the one it is most along tells the side.
// A center in the surface has no direction and counts as behind.
bool SleeveContacts::is_behind(const ShellModel& model) const
{
  double deepest = 0.0, side = 0.0;
  for (const FacetTouch& t : facets_) deepest = std::max(deepest, t.overlap);
  for (const FacetTouch& t : facets_) {
    if (t.overlap < 0.999 * deepest) continue;
    const FacetVectors corner = model.corners(t.facet);
    const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
    const double cosine = t.direction.dot(normal);
    if (std::abs(cosine) > std::abs(side)) side = cosine;
  }
  return !(side > 0.0);
}

void SleeveContacts::take_point(const ShellModel& model, const Vec3& point)
{
  levers_.clear();
  for (const FacetTouch& t : facets_) levers_.emplace_back(model.corners(t.facet), point);
}

SurfaceMotion SleeveContacts::surface_motion(const ShellModel& model) const
{
  SurfaceMotion motion{Vec3::Zero(), Vec3::Zero()};
  for (std::size_t n = 0; n < facets_.size(); ++n) {
    const Facet& node = model.facet()[facets_[n].facet];
    const FacetVectors velocity{model.velocity()[node[0]], model.velocity()[node[1]],
                                model.velocity()[node[2]]};
    const Vec3 spin = levers_[n].spin(velocity);
    motion.velocity += facets_[n].share * levers_[n].velocity(velocity, spin);
    motion.spin += facets_[n].share * spin;
  }
  return motion;
}

void SleeveContacts::press(ShellModel& model, double normal_force, const Vec3& shear,
                           const Vec3& moment) const
{
  for (std::size_t n = 0; n < facets_.size(); ++n) {
    const FacetTouch& t = facets_[n];
    const Facet& node = model.facet()[t.facet];
    const Vec3 normal = (normal_force * t.pull) * t.direction;
    const FacetVectors along = levers_[n].nodal_forces(t.share * shear, t.share * moment);
    for (int i = 0; i < 3; ++i) model.force(node[i]) += t.weight(i) * normal + along[i];
  }
}

// 2 k w for the node of weight w, so that the bounds of a node, with the grain on the other side,
// stay above the largest eigenvalue.
void SleeveContacts::add_stiffness(const ShellModel& model, double stiffness,
                                   std::vector<StiffnessBound>& bound) const
{
  for (const FacetTouch& t : facets_)
    for (int i = 0; i < 3; ++i)
      bound[model.facet()[t.facet][i]].translation += 2.0 * stiffness * t.share * t.weight(i);
}

}  // namespace encased_column
