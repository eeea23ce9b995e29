// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <cmath>

namespace encased_column {

using Mat2 = Eigen::Matrix2d;

/// The frame that turns with a deforming facet, and the stretch that is left after the turn.
///
/// `g1`, `g2` are the images of two orthogonal unit vectors of the reference facet (columns of the
/// 3 x 2 deformation gradient F). With C = F^T F and j = sqrt(det C),
///
///   U = (C + j I) / sqrt(tr C + 2 j),   [e1 e2] = F U^-1,   e3 = g1 x g2 / j.
///
/// The turn is the polar rotation of F: no edge or node is singled out, so the frame, and with it
/// the energy, does not depend on the order of the nodes.
/// Source: Hoger and Carlson, Quart. Appl. Math. 42 (1984) 113-117, square root of a 2 x 2 matrix.
/// Requires a facet of non-zero area; the caller checks `area_ratio`.
struct CorotationalFrame {
  Vec3 e1, e2, e3;
  double u11, u22, u12;  ///< U [-], in the reference axes
  double area_ratio;     ///< current over reference area [-]
  double inverse_trace;  ///< 1 / tr U [-]
  double inverse_area;   ///< 1 / area_ratio [-]

  CorotationalFrame(const Vec3& g1, const Vec3& g2)
  {
    const Vec3 normal = g1.cross(g2);
    area_ratio = normal.norm();
    const double c11 = g1.squaredNorm(), c22 = g2.squaredNorm(), c12 = g1.dot(g2);
    const double trace = std::sqrt(c11 + c22 + 2.0 * area_ratio);
    // One division for all: the vector units take longest over those.
    const double product = 1.0 / (trace * area_ratio);
    inverse_trace = product * area_ratio;
    inverse_area = product * trace;
    u11 = inverse_trace * (c11 + area_ratio);
    u22 = inverse_trace * (c22 + area_ratio);
    u12 = inverse_trace * c12;
    e1 = inverse_area * (u22 * g1 - u12 * g2);
    e2 = inverse_area * (u11 * g2 - u12 * g1);
    e3 = inverse_area * normal;
  }

  double trace() const { return u11 + u22; }
  Vec3 to_local(const Vec3& v) const { return {e1.dot(v), e2.dot(v), e3.dot(v)}; }
  Vec3 to_global(const Vec3& v) const { return v.x() * e1 + v.y() * e2 + v.z() * e3; }
};

/// Tilt (theta_x, theta_y) [rad] of a node's director against the facet's normal, in the facet's
/// frame: 2 tan(phi/2) about the axis e3 x d, with phi the angle between them. It is phi to third
/// order, grows without limit up to phi = pi and does not see a turn about the director itself,
/// so the drilling rotation of a node carries no energy.
struct DirectorTilt {
  double x, y;
  double scale;  ///< 2 / (1 + d3)

  explicit DirectorTilt(const Vec3& director) : DirectorTilt(director, 2.0 / (1.0 + director.z()))
  {
  }
  DirectorTilt(const Vec3& director, double scale) : scale(scale)
  {
    x = -scale * director.y();
    y = scale * director.x();
  }

  /// d x dW/dd, in the facet's frame, for the energy's slopes m = dW/d(theta_x, theta_y) [N m]:
  /// minus the moment on the node.
  Vec3 work_conjugate(const Vec3& director, double mx, double my) const
  {
    const Vec3 slope(scale * my, -scale * mx, -0.5 * scale * (mx * x + my * y));
    return director.cross(slope);
  }
};

}  // namespace encased_column
