// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

namespace encased_column {

/// The point of a triangle nearest to `x`, as area coordinates (each 0 to 1, sum 1).
/// Source: Ericson, Real-Time Collision Detection (2005), section 5.1.5: the region of the triangle
/// (corner, side or inside) that x lies over, found from signs of products; the first one counts.
/// Without branches and with one division, for the vector units.
inline Vec3 nearest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& x)
{
  const Vec3 ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
  const double d1 = ab.dot(ax), d2 = ac.dot(ax);
  const double d3 = ab.dot(bx), d4 = ac.dot(bx);
  const double d5 = ab.dot(cx), d6 = ac.dot(cx);
  // Inside, areas over the three sides; then the regions, from the last one back to the first.
  double wa = d3 * d6 - d5 * d4, wb = d5 * d2 - d1 * d6, wc = d1 * d4 - d3 * d2;
  const bool on_ab = (wc <= 0.0) & (d1 >= 0.0) & (d3 <= 0.0);
  const bool on_ac = (wb <= 0.0) & (d2 >= 0.0) & (d6 <= 0.0);
  const bool on_bc = (wa <= 0.0) & (d4 >= d3) & (d5 >= d6);
  const bool at_a = (d1 <= 0.0) & (d2 <= 0.0), at_b = (d3 >= 0.0) & (d4 <= d3),
             at_c = (d6 >= 0.0) & (d5 <= d6);
  const auto take = [&](bool is_there, double of_a, double of_b, double of_c) {
    wa = is_there ? of_a : wa;
    wb = is_there ? of_b : wb;
    wc = is_there ? of_c : wc;
  };
  take(on_bc, 0.0, d5 - d6, d4 - d3);
  take(on_ac, -d6, 0.0, d2);
  take(at_c, 0.0, 0.0, 1.0);
  take(on_ab, -d3, d1, 0.0);
  take(at_b, 0.0, 1.0, 0.0);
  take(at_a, 1.0, 0.0, 0.0);
  const double inverse = 1.0 / (wa + wb + wc);
  return {inverse * wa, inverse * wb, inverse * wc};
}

}  // namespace encased_column
