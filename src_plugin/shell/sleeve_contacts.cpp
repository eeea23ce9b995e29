#include "shell/sleeve_contacts.h"

#include "shell/height_bands.h"
#include "shell/nearest_point.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

void SleeveContacts::list(const ShellModel& model, const double* centers, const double* radii,
                          int grains, double margin)
{
  margin_ = margin;
  find_planes(model);
  listed_position_ = model.position();
  grid_.sort(model.facet(), model.position());
  grain_.clear();
  near_.clear();
  begin_.assign(1, 0);
  const HeightBands bands(model.facet(), model.position());
  for (int i = 0; i < grains; ++i) {
    const Vec3 center = as_vec3(centers + 3 * i);
    const double reach = radii[i] + 1.5 * margin;
    if (bands.is_clear(center, reach)) continue;  // most grains
    grid_.near(center, reach, [&](int f) {
      const FacetVectors corner = model.corners(f);
      const Vec3 weight = nearest_on_triangle(corner[0], corner[1], corner[2], center);
      const Vec3 point = weight(0) * corner[0] + weight(1) * corner[1] + weight(2) * corner[2];
      if ((point - center).squaredNorm() < reach * reach) near_.push_back(f);
    });
    const int end = static_cast<int>(near_.size());
    if (end == begin_.back()) continue;
    grain_.push_back(i);
    begin_.push_back(end);
  }
}

bool SleeveContacts::is_stale(const ShellModel& model) const
{
  const double limit = 0.25 * margin_ * margin_;
  for (int i = 0; i < model.nodes(); ++i)
    if ((model.position()[i] - listed_position_[i]).squaredNorm() > limit) return true;
  return false;
}

// A facet is near some ten grains.
void SleeveContacts::find_planes(const ShellModel& model)
{
  planes_.resize(model.facets());
  for (int f = 0; f < model.facets(); ++f) {
    const FacetVectors corner = model.corners(f);
    const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    planes_[f] = {normal, normal.dot(corner[0]), normal.squaredNorm()};
  }
}

bool SleeveContacts::touches(const ShellModel& model, int n, const Vec3& center, double radius)
{
  facets_.clear();
  for (int m = begin_[n]; m < begin_[n + 1]; ++m) {
    const int f = near_[m];
    // Most facets near by are out of reach of their plane already.
    const double height = planes_[f].offset - planes_[f].normal.dot(center);
    if (height * height >= radius * radius * planes_[f].square) continue;
    const FacetVectors corner = model.corners(f);
    const Vec3 weight = nearest_on_triangle(corner[0], corner[1], corner[2], center);
    const Vec3 way = weight(0) * corner[0] + weight(1) * corner[1] + weight(2) * corner[2] - center;
    const double square = way.squaredNorm();
    if (square >= radius * radius) continue;
    const double distance = std::sqrt(square);
    facets_.push_back({f, weight, way / distance, radius - distance, 0.0, 0.0});
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
