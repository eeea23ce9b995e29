// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace encased_column {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// The host's double[3] seen as a vector, without a copy.
inline Eigen::Map<Vec3> as_vec3(double* x)
{
  return Eigen::Map<Vec3>(x);
}
inline Eigen::Map<const Vec3> as_vec3(const double* x)
{
  return Eigen::Map<const Vec3>(x);
}

}  // namespace encased_column
