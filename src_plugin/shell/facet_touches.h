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

/// Pairs of a contact, from `first` to before `last`.
struct FacetPairs {
  int first, last;
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

  /// Puts pair `from` in the place `to`, which is not behind it.
  void move(int from, int to);
  /// Forgets the pairs from `count` on.
  void keep_first(int count) { count_ = count; }
  static constexpr int size = 32;  ///< contacts at most that are merged at once
  /// Merges the pairs of each of `count` contacts, all of which touch.
  void merge(const FacetPairs* pairs, int count, MergedContact* merged);
  double share(int p) const { return tile_of(p).share[p % size]; }

  /// Finds what the first `pairs` add to the motion of the surface, from the velocities of the
  /// nodes [m/s].
  void find_motion(int pairs, const std::vector<Vec3>& velocity);
  /// The part of a pair: its share times the motion of its facet.
  SurfaceMotion motion(int p) const
  {
    return {tile_of(p).linear.at(p % size), tile_of(p).angular.at(p % size)};
  }

  /// What the contact of a pair does to the sleeve: the normal force [N], shear force [N] and
  /// moment [N m] of all its facets.
  void set_load(int p, double normal_force, const Vec3& shear, const Vec3& moment)
  {
    Tile& tile = tile_of(p);
    const int n = p % size;
    tile.normal_force[n] = normal_force;
    tile.linear.set(n, shear);
    tile.angular.set(n, moment);
  }
  /// Adds the loads of the first `pairs` to the forces of the nodes [N]: the normal force along the
  /// facets' directions by their pull, shear force and moment at the contact by their share.
  void press(int pairs, Vec3* force);

 private:
  using Numbers = double[size];
  using Row = VectorRow<size>;
  struct alignas(64) Tile {
    Row corner[3];
    Row center, weight, direction, point;
    Numbers radius, gap, side, pull, share;
    Row nodal[3];         ///< velocities, then forces
    Row linear, angular;  ///< velocity and spin of the surface, then shear force and moment
    Numbers normal_force;
    Facet node[size];
  };
  /// Contacts and the sums over their pairs.
  struct alignas(64) Merging {
    Row center, gradient, normal, point;
    Numbers radius, deepest, powers, weights, overlap, stiffening, pull, share;
  };

  Tile& tile_of(int p) { return tiles_[p / size]; }
  const Tile& tile_of(int p) const { return tiles_[p / size]; }
  static int lanes(int tile, int pairs);
  static void nearest_of(Tile& tile, int n);
  static void motion_of(Tile& tile, int n);
  static void forces_of(Tile& tile, int n);
  static void join(Merging& merging, int n);
  static void join_all(Merging& merging, int lanes);
  static void find_nearest(Tile& tile, int first, int lanes);
  static void find_motion(Tile& tile, int lanes);
  static void find_forces(Tile& tile, int lanes);

  int count_ = 0;
  std::vector<int> facet_;
  std::vector<Tile> tiles_;
  Merging merging_{};
};

}  // namespace encased_column
