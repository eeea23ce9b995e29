// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/linear_law.h"
#include "core/vec3.h"

#include <cmath>

namespace encased_column {

/// The one contact that a sphere makes with all facets it touches.
struct MergedContact {
  double overlap;     ///< [m]
  Vec3 normal;        ///< unit, from the center to the surface
  double stiffening;  ///< factor on the normal stiffness, at most n^(1/4) for n facets [-]
};

/// The touches of one sphere with a faceted surface, joined into one contact that does not jump
/// where the sphere rolls from facet to facet.
///
/// With the overlaps o_i = R - distance to facet i the contact stores V = k o^2 / 2,
///
///   o = (sum o_i^8)^(1/8),
///
/// a smooth maximum: the distance to a triangle is differentiable everywhere outside it, so V is,
/// and force and nodal forces are its gradients. On one facet o = o_1; over an edge shared by two
/// it is at most 2^(1/8) = 1.09 o_1. The force k o sum w_i d_i, w_i = (o_i / o)^7, is given as that
/// of a contact of overlap o / g and stiffness k g^2, g = |sum w_i d_i|: of the same force and
/// energy, with the overlap that the surface really has. (Adding up the facets' own forces would
/// double the stiffness over every edge; taking the deepest facet would make the normal jump.)
///
/// With u_i = (o_i / deepest)^7 in place of w_i no root of the sum of eighth powers is needed but
/// for the stiffness, and no division for each facet.
struct TouchSum {
  double deepest;  ///< overlap [m]
  double powers = 0.0, weights = 0.0;
  Vec3 gradient = Vec3::Zero();

  /// Adds the touch with a facet along the unit vector `direction` from the center; `part` is its
  /// overlap over the deepest. Returns its u_i.
  double add(double part, const Vec3& direction)
  {
    const double square = part * part, cube = square * part, u = cube * cube * part;
    powers += u * part;
    weights += u;
    gradient += u * direction;
    return u;
  }
};

/// The contact, and what the u of a facet is to be multiplied by for its pull, its part of the
/// normal force along its direction, and its share of shear force and wall velocity, all of which
/// sum to 1 [-].
struct JoinedTouches {
  MergedContact contact;
  double pull, share;
};

/// Without branches and with one division, for the vector units.
inline JoinedTouches joined(const TouchSum& sum)
{
  const double length = std::sqrt(sum.gradient.squaredNorm());
  const double of_all = 1.0 / (length * sum.weights * sum.powers);
  const double by_length = of_all * sum.weights * sum.powers;
  const double by_weights = of_all * length * sum.powers;
  const double bend = length * (of_all * length * sum.weights);  // g is this times powers^(1/8)
  return {{sum.deepest * sum.powers * by_length, by_length * sum.gradient,
           bend * bend * std::sqrt(std::sqrt(sum.powers))},
          by_length,
          by_weights};
}

/// The material of the one contact that merged touches make: stiffer along the normal; its shear
/// spring is the same on facets and edges, else it would gain energy where it stiffens.
inline ContactMaterial stiffened(ContactMaterial material, const MergedContact& touch)
{
  material.modulus *= touch.stiffening;
  material.stiffness_ratio *= touch.stiffening;
  return material;
}

}  // namespace encased_column
