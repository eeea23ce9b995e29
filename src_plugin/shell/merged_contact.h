// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/linear_law.h"
#include "core/vec3.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace encased_column {

/// A sphere and one facet that overlap.
struct FacetTouch {
  int facet;
  Vec3 weight;     ///< area coordinates of the facet's nearest point [-]
  Vec3 direction;  ///< unit, from the center to that point
  double overlap;  ///< radius less distance, larger than zero [m]
  double pull;     ///< of the normal force, along `direction` [-]; set by merge_touches()
  double share;    ///< of shear force and wall velocity, sums to 1 [-]; set by merge_touches()
};

/// The one contact that all of them make.
struct MergedContact {
  double overlap;     ///< [m]
  Vec3 normal;        ///< unit, from the center to the surface
  double stiffening;  ///< factor on the normal stiffness, at most n^(1/4) for n facets [-]
};

/// Joins the touches of one sphere with a faceted surface into one contact that does not jump where
/// the sphere rolls from facet to facet.
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
inline MergedContact merge_touches(std::vector<FacetTouch>& touches)
{
  if (touches.size() == 1) {
    touches[0].pull = touches[0].share = 1.0;
    return {touches[0].overlap, touches[0].direction, 1.0};
  }
  double deepest = 0.0;
  for (const FacetTouch& t : touches) deepest = std::max(deepest, t.overlap);
  // With u_i = (o_i / deepest)^7 in place of w_i no root of the sum of eighth powers is needed but
  // for the stiffness, and no division for each facet.
  const double inverse = 1.0 / deepest;
  double sum = 0.0, weights = 0.0;
  Vec3 gradient = Vec3::Zero();
  for (FacetTouch& t : touches) {
    const double ratio = inverse * t.overlap, square = ratio * ratio, cube = square * ratio;
    t.pull = cube * cube * ratio;
    sum += t.pull * ratio;
    weights += t.pull;
    gradient += t.pull * t.direction;
  }
  const double length = gradient.norm();
  const double of_all = 1.0 / (length * weights * sum);
  const double by_length = of_all * weights * sum, by_weights = of_all * length * sum;
  for (FacetTouch& t : touches) {
    t.share = by_weights * t.pull;
    t.pull *= by_length;
  }
  const double bend = length * (of_all * length * weights);  // g is this times sum^(1/8)
  return {deepest * sum * by_length, by_length * gradient, bend * bend * std::sqrt(std::sqrt(sum))};
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
