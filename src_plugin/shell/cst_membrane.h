// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"
#include "shell/corotational_frame.h"

namespace encased_column {

using Vec2 = Eigen::Vector2d;
/// Corners of a plane triangle as columns [m].
using Triangle2 = Eigen::Matrix<double, 2, 3>;
/// Strains (e11, e22, 2 e12) [-], or the forces per length (N11, N22, N12) [N/m] conjugate to them.
using PlaneVector = Eigen::Vector3d;

/// Signed area [m^2] of a plane triangle, positive counter-clockwise.
inline double triangle_area(const Triangle2& corner)
{
  const Vec2 a = corner.col(1) - corner.col(0), b = corner.col(2) - corner.col(0);
  return 0.5 * (a.x() * b.y() - a.y() * b.x());
}

/// Gradients of the three area coordinates as columns [1/m].
inline Triangle2 area_coordinate_gradients(const Triangle2& corner)
{
  const double twice = 2.0 * triangle_area(corner);
  Triangle2 gradient;
  for (int i = 0; i < 3; ++i) {
    const Vec2 opposite = corner.col((i + 2) % 3) - corner.col((i + 1) % 3);
    gradient.col(i) = Vec2(-opposite.y(), opposite.x()) / twice;
  }
  return gradient;
}

/// Engineering strain of the facet in its own plane: U - I, with U the stretch of the corotational
/// frame (Biot strain). At any strain a fibre along a principal direction has its elongation over
/// its reference length, the strain of a strip test; shear is 2 U12.
inline PlaneVector membrane_strain(const CorotationalFrame& frame)
{
  return {frame.u11 - 1.0, frame.u22 - 1.0, 2.0 * frame.u12};
}

/// Derivative of the membrane energy per reference area w(U - I) by the columns g1, g2 of the
/// deformation gradient, where `n` = dw/d(strain) [N/m].
///
/// dw = n : dU, and F = Q U gives Q^T dF = alpha J U + dU with J the quarter turn and alpha the
/// spin: p = Q (n + s J) with s = -n : (J U) / tr U takes the spin out again, so that p : dF = dw
/// exactly, also where stress and stretch have different axes (orthotropy).
struct MembranePull {
  Vec3 p1, p2;  ///< [N/m]

  MembranePull(const CorotationalFrame& frame, const PlaneVector& n)
  {
    const double s =
        frame.inverse_trace * (frame.u12 * (n(0) - n(1)) - n(2) * (frame.u11 - frame.u22));
    p1 = n(0) * frame.e1 + (n(2) + s) * frame.e2;
    p2 = (n(2) - s) * frame.e1 + n(1) * frame.e2;
  }
};

}  // namespace encased_column
