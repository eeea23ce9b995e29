#pragma once

#include "core/vec3.h"

namespace encased_column {

/// Vectors side by side, component by component, as vector units take them.
template <int size>
struct VectorRow {
  double x[size], y[size], z[size];

  Vec3 at(int n) const { return {x[n], y[n], z[n]}; }
  void set(int n, const Vec3& v) { x[n] = v.x(), y[n] = v.y(), z[n] = v.z(); }
};

}  // namespace encased_column
