// SPDX-License-Identifier: GPL-2.0-only
// Vectors of three spread over the halves of a vector register would keep rows of them from it.
// Nothing here may depend on how Eigen aligns larger matrices, which this changes.
#define EIGEN_DONT_VECTORIZE

#include "shell/facet_touches.h"

#include "contact/resolve_contact.h"
#include "shell/contact_to_nodes.h"
#include "shell/nearest_point.h"

#include <algorithm>

namespace encased_column {

namespace {

constexpr int widest = 8;  ///< numbers that the widest vector unit takes at once

}  // namespace

void FacetTouches::make_room(int pairs)
{
  const std::size_t tiles = (pairs + size - 1) / size;
  if (tiles <= tiles_.size()) return;
  tiles_.resize(tiles, Tile{});
  facet_.resize(tiles * size);
}

void FacetTouches::move(int from, int to)
{
  if (from == to) return;
  const Tile& old = tile_of(from);
  Tile& tile = tile_of(to);
  const int m = from % size, n = to % size;
  facet_[to] = facet_[from];
  tile.node[n] = old.node[m];
  for (int i = 0; i < 3; ++i) tile.corner[i].set(n, old.corner[i].at(m));
  tile.center.set(n, old.center.at(m));
  tile.radius[n] = old.radius[m];
  tile.weight.set(n, old.weight.at(m));
  tile.direction.set(n, old.direction.at(m));
  tile.gap[n] = old.gap[m];
  tile.side[n] = old.side[m];
  tile.pull[n] = old.pull[m];
  tile.share[n] = old.share[m];
  tile.point.set(n, old.point.at(m));
}

/// Of a tile those before pair number `pairs`, and some more, so that no vector is left over.
int FacetTouches::lanes(int tile, int pairs)
{
  const int count = std::min(pairs - tile * size, size);
  return (count + widest - 1) / widest * widest;
}

// Each pair in a function of its own, since what is declared in the loop itself would stay in
// memory; the loops flat, since a call would keep them from the vector units.
void FacetTouches::nearest_of(Tile& tile, int n)
{
  const Vec3 a = tile.corner[0].at(n), b = tile.corner[1].at(n), c = tile.corner[2].at(n);
  const Vec3 center = tile.center.at(n);
  const Vec3 weight = nearest_on_triangle(a, b, c, center);
  const Vec3 way = weight(0) * a + weight(1) * b + weight(2) * c - center;
  const Vec3 normal = (b - a).cross(c - a);
  const double distance = std::sqrt(way.squaredNorm()), length = std::sqrt(normal.squaredNorm());
  const double inverse = 1.0 / (distance * length);
  tile.weight.set(n, weight);
  tile.direction.set(n, (inverse * length) * way);
  tile.gap[n] = distance - tile.radius[n];
  tile.side[n] = inverse * way.dot(normal);
}

ENCASE_VECTOR_UNITS [[gnu::flatten]] void FacetTouches::find_nearest(Tile& tile, int first,
                                                                     int lanes)
{
#pragma omp simd
  for (int n = first; n < lanes; ++n) nearest_of(tile, n);
}

void FacetTouches::join(Merging& merging, int n)
{
  const JoinedTouches touches =
      joined({merging.deepest[n], merging.powers[n], merging.weights[n], merging.gradient.at(n)});
  const MergedContact& contact = touches.contact;
  merging.overlap[n] = contact.overlap;
  merging.normal.set(n, contact.normal);
  merging.stiffening[n] = contact.stiffening;
  merging.pull[n] = touches.pull;
  merging.share[n] = touches.share;
  merging.point.set(
      n, merging.center.at(n) + contact_arm(merging.radius[n], contact.overlap) * contact.normal);
}

ENCASE_VECTOR_UNITS [[gnu::flatten]] void FacetTouches::join_all(Merging& merging, int lanes)
{
#pragma omp simd
  for (int n = 0; n < lanes; ++n) join(merging, n);
}

void FacetTouches::merge(const FacetPairs* pairs, int count, MergedContact* merged)
{
  for (int c = 0; c < count; ++c) {
    TouchSum sum{0.0};
    for (int p = pairs[c].first; p < pairs[c].last; ++p)
      sum.deepest = std::max(sum.deepest, -gap(p));
    const double inverse = 1.0 / sum.deepest;
    for (int p = pairs[c].first; p < pairs[c].last; ++p) {
      Tile& tile = tile_of(p);
      const int n = p % size;
      tile.pull[n] = tile.share[n] = sum.add(inverse * -tile.gap[n], tile.direction.at(n));
    }
    const int first = pairs[c].first;
    merging_.center.set(c, tile_of(first).center.at(first % size));
    merging_.radius[c] = tile_of(first).radius[first % size];
    merging_.deepest[c] = sum.deepest;
    merging_.powers[c] = sum.powers;
    merging_.weights[c] = sum.weights;
    merging_.gradient.set(c, sum.gradient);
  }
  join_all(merging_, lanes(0, count));
  for (int c = 0; c < count; ++c) {
    merged[c] = {merging_.overlap[c], merging_.normal.at(c), merging_.stiffening[c]};
    for (int p = pairs[c].first; p < pairs[c].last; ++p) {
      Tile& tile = tile_of(p);
      const int n = p % size;
      tile.pull[n] *= merging_.pull[c];
      tile.share[n] *= merging_.share[c];
      tile.point.set(n, merging_.point.at(c));
    }
  }
}

void FacetTouches::motion_of(Tile& tile, int n)
{
  const FacetLever lever({tile.corner[0].at(n), tile.corner[1].at(n), tile.corner[2].at(n)},
                         tile.point.at(n));
  const std::array<Vec3, 3> velocity{tile.nodal[0].at(n), tile.nodal[1].at(n), tile.nodal[2].at(n)};
  const Vec3 spin = lever.spin(velocity);
  tile.linear.set(n, tile.share[n] * lever.velocity(velocity, spin));
  tile.angular.set(n, tile.share[n] * spin);
}

ENCASE_VECTOR_UNITS [[gnu::flatten]] void FacetTouches::find_motion(Tile& tile, int lanes)
{
#pragma omp simd
  for (int n = 0; n < lanes; ++n) motion_of(tile, n);
}

void FacetTouches::forces_of(Tile& tile, int n)
{
  const FacetLever lever({tile.corner[0].at(n), tile.corner[1].at(n), tile.corner[2].at(n)},
                         tile.point.at(n));
  const Vec3 normal = (tile.normal_force[n] * tile.pull[n]) * tile.direction.at(n);
  const Vec3 shear = tile.share[n] * tile.linear.at(n);
  const Vec3 moment = tile.share[n] * tile.angular.at(n);
  const Vec3 weight = tile.weight.at(n);
  const std::array<Vec3, 3> along = lever.nodal_forces(shear, moment);
  for (int i = 0; i < 3; ++i) tile.nodal[i].set(n, weight(i) * normal + along[i]);
}

ENCASE_VECTOR_UNITS [[gnu::flatten]] void FacetTouches::find_forces(Tile& tile, int lanes)
{
#pragma omp simd
  for (int n = 0; n < lanes; ++n) forces_of(tile, n);
}

// From the start of a vector on: what is found again comes out the same.
void FacetTouches::find_nearest(int first)
{
  first = first / widest * widest;
  for (int t = first / size; t * size < count_; ++t)
    find_nearest(tiles_[t], std::max(first - t * size, 0), lanes(t, count_));
}

void FacetTouches::find_motion(int pairs, const std::vector<Vec3>& velocity)
{
  for (int p = 0; p < pairs; ++p) {
    Tile& tile = tile_of(p);
    const int n = p % size;
    for (int i = 0; i < 3; ++i) tile.nodal[i].set(n, velocity[tile.node[n][i]]);
  }
  for (int t = 0; t * size < pairs; ++t) find_motion(tiles_[t], lanes(t, pairs));
}

void FacetTouches::press(int pairs, Vec3* force)
{
  for (int t = 0; t * size < pairs; ++t) find_forces(tiles_[t], lanes(t, pairs));
  for (int p = 0; p < pairs; ++p) {
    const Tile& tile = tile_of(p);
    const int n = p % size;
    for (int i = 0; i < 3; ++i) force[tile.node[n][i]] += tile.nodal[i].at(n);
  }
}

}  // namespace encased_column
