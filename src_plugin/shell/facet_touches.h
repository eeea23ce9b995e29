// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vector_units.h"
#include "shell/merged_contact.h"
#include "shell/surface_mesh.h"

#include <vector>

namespace encased_column {

/// Motion of the sleeve's surface at a contact.
struct SurfaceMotion {
  Vec3 velocity = Vec3::Zero();  ///< [m/s]
  Vec3 spin = Vec3::Zero();      ///< [rad/s]
};

/// Spheres and facets near each other, pair by pair side by side, so that the vector units of the
/// machine see to several at once: where they are nearest, how the surface moves at a contact, and
/// what the nodes feel. Pairs have numbers in the order in which they were added.
class FacetTouches {
 public:
  /// Takes room for at least so many pairs.
  void make_room(int pairs);
  bool has_room(int pairs) const { return count_ + pairs <= static_cast<int>(facet_.size()); }
  int count() const { return count_; }
  void clear() { count_ = 0; }

  void add(int facet, const Facet& node, const std::vector<Vec3>& position, const Vec3& center,
           double radius)
  {
    const int p = count_++;
    Tile& tile = tile_of(p);
    const int n = p % size;
    facet_[p] = facet;
    tile.node[n] = node;
    for (int i = 0; i < 3; ++i) tile.corner[i].set(n, position[node[i]]);
    tile.center.set(n, center);
    tile.radius[n] = radius;
  }

  /// Finds the nearest points of the pairs from `first` on.
  void find_nearest(int first);
  int facet(int p) const { return facet_[p]; }
  const Facet& node(int p) const { return tile_of(p).node[p % size]; }
  /// Between sphere and facet, below zero where they touch [m].
  double gap(int p) const { return tile_of(p).gap[p % size]; }
  /// Cosine between the direction to the nearest point and the normal of the facet; not a number
  /// where the center lies in the facet.
  double side(int p) const { return tile_of(p).side[p % size]; }
  Vec3 weight(int p) const { return tile_of(p).weight.at(p % size); }
  Vec3 direction(int p) const { return tile_of(p).direction.at(p % size); }
  Vec3 center(int p) const { return tile_of(p).center.at(p % size); }
  double radius(int p) const { return tile_of(p).radius[p % size]; }
  FacetTouch touch(int p) const { return {facet_[p], weight(p), direction(p), -gap(p), 0.0, 0.0}; }

  /// Puts pair `from` in the place `to`, which is not behind it.
  void move(int from, int to);
  /// Forgets the pairs from `count` on.
  void keep_first(int count) { count_ = count; }
  /// Of a pair that touches: its pull and share in its merged contact, as merge_touches() sets
  /// them, and the point of that contact [m].
  void join(int p, double pull, double share, const Vec3& point);
  double share(int p) const { return tile_of(p).share[p % size]; }

  /// Finds what the first `pairs` add to the motion of the surface, from the velocities of the
  /// nodes [m/s].
  void find_motion(int pairs, const std::vector<Vec3>& velocity);
  /// The part of a pair: its share times the motion of its facet.
  SurfaceMotion motion(int p) const
  {
    return {tile_of(p).velocity.at(p % size), tile_of(p).spin.at(p % size)};
  }

  /// What the contact of a pair does to the sleeve: the normal force [N], shear force [N] and
  /// moment [N m] of all its facets.
  void set_load(int p, double normal_force, const Vec3& shear, const Vec3& moment)
  {
    Tile& tile = tile_of(p);
    const int n = p % size;
    tile.normal_force[n] = normal_force;
    tile.shear.set(n, shear);
    tile.moment.set(n, moment);
  }
  /// Adds the loads of the first `pairs` to the forces of the nodes [N]: the normal force along the
  /// facets' directions by their pull, shear force and moment at the contact by their share.
  void press(int pairs, Vec3* force);

 private:
  static constexpr int size = 32;
  using Numbers = double[size];
  using Row = VectorRow<size>;
  struct alignas(64) Tile {
    Row corner[3];
    Row center, weight, direction, point;
    Numbers radius, gap, side, pull, share;
    Row node_velocity[3], velocity, spin;
    Numbers normal_force;
    Row shear, moment, node_force[3];
    Facet node[size];
  };

  Tile& tile_of(int p) { return tiles_[p / size]; }
  const Tile& tile_of(int p) const { return tiles_[p / size]; }
  static int lanes(int tile, int pairs);
  static void nearest_of(Tile& tile, int n);
  static void motion_of(Tile& tile, int n);
  static void forces_of(Tile& tile, int n);
  static void find_nearest(Tile& tile, int first, int lanes);
  static void find_motion(Tile& tile, int lanes);
  static void find_forces(Tile& tile, int lanes);

  int count_ = 0;
  std::vector<int> facet_;
  std::vector<Tile> tiles_;
};

}  // namespace encased_column
