// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

/// Marks a function whose loops are compiled for the vector units of newer machines too; which one
/// runs is decided when the program is loaded. Sanitizers have no say at that time, and instrument
/// the plain one.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define ENCASE_VECTOR_UNITS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define ENCASE_VECTOR_UNITS
#endif

namespace encased_column {

/// Vectors side by side, component by component, as vector units take them.
template <int size>
struct VectorRow {
  double x[size], y[size], z[size];

  Vec3 at(int n) const { return {x[n], y[n], z[n]}; }
  void set(int n, const Vec3& v) { x[n] = v.x(), y[n] = v.y(), z[n] = v.z(); }
};

}  // namespace encased_column
