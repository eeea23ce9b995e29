// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/cst_membrane.h"

#include <array>

namespace encased_column {

/// Plate freedoms (w, theta_x, theta_y) of the three corners, theta_x = dw/dy, theta_y = -dw/dx.
using CurvatureMatrix = Eigen::Matrix<double, 3, 9>;
using PlateStiffness = Eigen::Matrix<double, 9, 9>;
/// The part of the plate stiffness that the six rotations see.
using TiltStiffness = Eigen::Matrix<double, 6, 6>;

/// Curvatures (w,xx, w,yy, 2 w,xy) [1/m] of the discrete-Kirchhoff triangle at a point.
///
/// The slopes (w,x, w,y) vary quadratically: nodal values at the corners; at the middle of a side
/// of length L and direction s the slope along s is that of the cubic through the ends,
/// 3 (w_j - w_i) / (2 L) - (w,s_i + w,s_j) / 4, and the slope across is the mean of the ends.
/// Source: Batoz, Bathe and Ho, "A study of three-node triangular plate bending elements",
/// Int. J. Num. Meth. Eng. 15 (1980) 1771-1812, section 3; written here in slopes, not in their
/// expanded form, so that each line can be checked against the assumptions above.
inline CurvatureMatrix dkt_curvature(const Triangle2& corner, const Vec3& area_coordinate)
{
  using SlopeMatrix = Eigen::Matrix<double, 2, 9>;
  const Triangle2 gradient = area_coordinate_gradients(corner);
  CurvatureMatrix curvature = CurvatureMatrix::Zero();
  const auto add = [&curvature](const SlopeMatrix& slope, const Vec2& shape_gradient) {
    curvature.row(0) += shape_gradient.x() * slope.row(0);
    curvature.row(1) += shape_gradient.y() * slope.row(1);
    curvature.row(2) += shape_gradient.y() * slope.row(0) + shape_gradient.x() * slope.row(1);
  };

  std::array<SlopeMatrix, 3> at_corner;
  for (int i = 0; i < 3; ++i) {
    at_corner[i].setZero();
    at_corner[i](0, 3 * i + 2) = -1.0;
    at_corner[i](1, 3 * i + 1) = 1.0;
    add(at_corner[i], (4.0 * area_coordinate(i) - 1.0) * gradient.col(i));
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vec2 side = corner.col(j) - corner.col(i);
    const double length = side.norm();
    const Vec2 direction = side / length;
    const SlopeMatrix sum = at_corner[i] + at_corner[j];
    Eigen::Matrix<double, 1, 9> along = -0.75 * direction.transpose() * sum;
    along(3 * i) -= 1.5 / length;
    along(3 * j) += 1.5 / length;
    add(0.5 * sum + direction * along,
        4.0 * (area_coordinate(i) * gradient.col(j) + area_coordinate(j) * gradient.col(i)));
  }
  return curvature;
}

/// Plate stiffness with the moment-curvature matrix `rigidity` [N m]. The curvatures are linear, so
/// the rule of the three mid-side points (weights 1/6 on a triangle of area 1/2) is exact.
inline PlateStiffness dkt_stiffness(const Triangle2& corner, const Mat3& rigidity)
{
  const double weight = 1.0 / 6.0, jacobian = 2.0 * triangle_area(corner);
  PlateStiffness stiffness = PlateStiffness::Zero();
  for (const Vec3& point : {Vec3(0.5, 0.5, 0.0), Vec3(0.0, 0.5, 0.5), Vec3(0.5, 0.0, 0.5)}) {
    const CurvatureMatrix curvature = dkt_curvature(corner, point);
    stiffness += weight * jacobian * curvature.transpose() * rigidity * curvature;
  }
  return stiffness;
}

/// The same for corners that stay in the facet's plane (w = 0), as in the corotational frame.
inline TiltStiffness dkt_tilt_stiffness(const Triangle2& corner, const Mat3& rigidity)
{
  const PlateStiffness full = dkt_stiffness(corner, rigidity);
  const std::array<int, 6> rotation{1, 2, 4, 5, 7, 8};
  TiltStiffness stiffness;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) stiffness(i, j) = full(rotation[i], rotation[j]);
  return stiffness;
}

}  // namespace encased_column
