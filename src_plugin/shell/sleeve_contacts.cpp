// SPDX-License-Identifier: GPL-2.0-only
#include "shell/sleeve_contacts.h"

#include "shell/height_bands.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace encased_column {

namespace {

/// Part of the margin within which facets are close: grain and sleeve may move by as much before
/// all near by are looked at again.
constexpr double look_again = 0.1;

}  // namespace

void SleeveContacts::list(const ShellModel& model, const double* centers, const double* radii,
                          int grains, const GrainReach& grain_reach)
{
  margin_ = grain_reach.skin();
  listed_travel_ = model.travel();
  listed_position_ = model.position();
  grid_.sort(model.facet(), model.position());
  grain_.clear();
  near_.clear();
  hold_.clear();
  facet_.clear();
  const HeightBands bands(model.facet(), model.position());
  for (int i = 0; i < grains; ++i) {
    const Vec3 center = as_vec3(centers + 3 * i);
    const double reach = radii[i] + grain_reach.margin(i);
    if (bands.is_clear(center, reach)) continue;  // most grains
    const Near near = find_facets(model, center, radii[i], reach);
    if (near.end == near.begin) continue;
    grain_.push_back(i);
    near_.push_back(near);
    hold_.push_back(not_looked_at(center));
  }
  make_room();
}

// Nodes may be half the margin from where the grid found them, and move by all of it.
void SleeveContacts::add_wider(const ShellModel& model, const double* centers, const double* radii,
                               int grains, const GrainReach& grain_reach)
{
  for (const int i : grain_reach.wider()) {
    if (i >= grains) continue;  // a ghost
    const double reach = radii[i] + grain_reach.margin(i) + 0.5 * margin_;
    const Vec3 center = as_vec3(centers + 3 * i);
    const Near near = find_facets(model, center, radii[i], reach);
    if (near.end == near.begin) continue;
    const auto place = std::lower_bound(grain_.begin(), grain_.end(), i);
    const auto n = place - grain_.begin();
    if (place != grain_.end() && *place == i) {
      near_[n] = near;
      hold_[n] = not_looked_at(center);
    } else {
      grain_.insert(place, i);
      near_.insert(near_.begin() + n, near);
      hold_.insert(hold_.begin() + n, not_looked_at(center));
    }
  }
  make_room();
}

/// Lists the facets within `reach` [m] of a grain.
SleeveContacts::Near SleeveContacts::find_facets(const ShellModel& model, const Vec3& center,
                                                 double radius, double reach)
{
  const int begin = static_cast<int>(facet_.size());
  touches_.clear();
  grid_.near(center, reach, [&](int f) {
    touches_.make_room(touches_.count() + 1);
    touches_.add(f, model.facet()[f], model.position(), center, radius);
  });
  touches_.find_nearest(0);
  for (int p = 0; p < touches_.count(); ++p)
    if (touches_.gap(p) < reach - radius) facet_.push_back(touches_.facet(p));
  const int end = static_cast<int>(facet_.size());
  return {begin, end, not_known, -std::numeric_limits<double>::infinity(), radius + model.travel()};
}

/// Nothing is known of its gaps: it is looked at as soon as contacts are asked for.
SleeveContacts::Hold SleeveContacts::not_looked_at(const Vec3& center)
{
  return {center, -std::numeric_limits<double>::infinity()};
}

void SleeveContacts::make_room()
{
  int most = 0;
  for (const Near& near : near_) most = std::max(most, near.end - near.begin);
  close_.resize(facet_.size());
  pick_.resize(grain_.size());
  touches_.make_room((in_block + 1) * most);  // of a block, and those of one grain
}

bool SleeveContacts::is_stale(const ShellModel& model) const
{
  if (model.travel() - listed_travel_ <= 0.5 * margin_) return false;
  const double limit = 0.25 * margin_ * margin_;
  for (int i = 0; i < model.nodes(); ++i)
    if ((model.position()[i] - listed_position_[i]).squaredNorm() > limit) return true;
  return false;
}

// Most facets near by stay out of reach for hundreds of steps: their gaps close no faster than the
// grain and the sleeve move and the grain grows.
void SleeveContacts::look_at(const ShellModel& model, int n, const Vec3& center, double radius)
{
  Near& near = near_[n];
  const double size_travel = radius + model.travel();
  const double closed = size_travel - near.size_travel + (center - hold_[n].center).norm();
  near.size_travel = size_travel;
  hold_[n].center = center;
  near.clear_rest -= closed;
  Look& look = look_[looks_++];
  look = {n, touches_.count(), 0, !(near.clear_rest > 0.0)};
  const auto add = [&](int f, const Facet& node) {
    touches_.add(f, node, model.position(), center, radius);
  };
  if (look.all)
    for (int m = near.begin; m < near.end; ++m) add(facet_[m], model.facet()[facet_[m]]);
  else
    for (int m = near.begin; m < near.begin + near.close; ++m)
      if (!((close_[m].gap -= closed) > 0.0)) add(close_[m].facet, close_[m].node);
  look.last = touches_.count();
}

void SleeveContacts::take_gaps(const Look& look)
{
  Near& near = near_[look.n];
  int p = look.first;
  if (look.all) {
    near.close = 0;
    near.clear_rest = std::numeric_limits<double>::infinity();
    for (; p < look.last; ++p)
      if (const double gap = touches_.gap(p); gap > look_again * margin_)
        near.clear_rest = std::min(near.clear_rest, gap);
      else
        close_[near.begin + near.close++] = {gap, touches_.facet(p), touches_.node(p)};
  }
  double clear = near.clear_rest;
  for (int m = near.begin; m < near.begin + near.close; ++m) {
    double& gap = close_[m].gap;
    if (!look.all && !(gap > 0.0)) gap = touches_.gap(p++);
    clear = std::min(clear, gap);
  }
  hold_[look.n].until = clear + near.size_travel;
}

std::optional<GrainBehind> SleeveContacts::find_contacts()
{
  if (looks_ == 0) return {};
  int kept = look_[0].first;
  touches_.find_nearest(kept);
  const int before = contacts_;
  for (int l = 0; l < looks_; ++l) {
    const Look& look = look_[l];
    take_gaps(look);
    FacetPairs pairs{kept, kept};
    for (int p = look.first; p < look.last; ++p)
      if (touches_.gap(p) < 0.0) touches_.move(p, kept++);
    pairs.last = kept;
    if (pairs.last == pairs.first) continue;
    const int grain = grain_[look.n];
    if (is_behind(pairs)) return GrainBehind{grain, touches_.facet(pairs.first)};
    SleeveContact& contact = contact_[contacts_];
    contact.n = look.n;
    contact.grain = grain;
    contact.surface = {};
    pairs_[contacts_++] = pairs;
  }
  std::array<MergedContact, in_block> merged;
  touches_.merge(pairs_.data() + before, contacts_ - before, merged.data());
  for (int c = before; c < contacts_; ++c) contact_[c].merged = merged[c - before];
  touches_.keep_first(kept);
  return {};
}

// Over an edge or a node several facets are as deep. At a sharp fold the direction may point
// against the normal of one of them on the right side too: the one it is most along tells the side.
// A center in the surface has no direction and counts as behind.
bool SleeveContacts::is_behind(const FacetPairs& pairs) const
{
  if (pairs.last == pairs.first + 1) return !(touches_.side(pairs.first) > 0.0);  // most of them
  double nearest = 0.0, side = 0.0;
  for (int p = pairs.first; p < pairs.last; ++p) nearest = std::min(nearest, touches_.gap(p));
  for (int p = pairs.first; p < pairs.last; ++p) {
    const double cosine = touches_.side(p);
    if (touches_.gap(p) <= 0.999 * nearest && std::abs(cosine) > std::abs(side)) side = cosine;
  }
  return !(side > 0.0);
}

void SleeveContacts::find_motion(int count, const ShellModel& model)
{
  touches_.find_motion(pairs_[count - 1].last, model.velocity());
  for (int c = 0; c < count; ++c) {
    SurfaceMotion sum = touches_.motion(pairs_[c].first);
    for (int p = pairs_[c].first + 1; p < pairs_[c].last; ++p) {
      const SurfaceMotion motion = touches_.motion(p);
      sum.velocity += motion.velocity;
      sum.spin += motion.spin;
    }
    contact_[c].surface = sum;
  }
}

void SleeveContacts::take_reactions(int count, ShellModel& model, bool moves,
                                    std::vector<StiffnessBound>* bound)
{
  for (int c = 0; c < count; ++c) {
    const SleeveReaction& reaction = reaction_[c];
    vertical_force_ -= reaction.force.z();
    const Vec3 shear = -reaction.force - reaction.normal_force * contact_[c].merged.normal;
    for (int p = pairs_[c].first; p < pairs_[c].last; ++p) {
      touches_.set_load(p, reaction.normal_force, shear, reaction.moment);
      if (bound) add_stiffness(p, reaction.stiffness, *bound);
    }
  }
  if (moves) touches_.press(pairs_[count - 1].last, model.load().data());
}

void SleeveContacts::forget(int count)
{
  const int gone = pairs_[count - 1].last;
  for (int p = gone; p < touches_.count(); ++p) touches_.move(p, p - gone);
  touches_.keep_first(touches_.count() - gone);
  contacts_ -= count;
  for (int c = 0; c < contacts_; ++c) {
    contact_[c] = contact_[c + count];
    pairs_[c] = {pairs_[c + count].first - gone, pairs_[c + count].last - gone};
  }
}

// 2 k w for the node of weight w, so that the bounds of a node, with the grain on the other side,
// stay above the largest eigenvalue.
void SleeveContacts::add_stiffness(int p, double stiffness,
                                   std::vector<StiffnessBound>& bound) const
{
  const Vec3 weight = touches_.weight(p);
  for (int i = 0; i < 3; ++i)
    bound[touches_.node(p)[i]].translation += 2.0 * stiffness * touches_.share(p) * weight(i);
}

}  // namespace encased_column
