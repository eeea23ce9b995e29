// SPDX-License-Identifier: GPL-2.0-only
// Vectors of three spread over the halves of a vector register would keep rows of them from it.
#define EIGEN_DONT_VECTORIZE

#include "shell/pressure_load.h"

#include "core/vector_units.h"

#include <algorithm>

namespace encased_column {

namespace {

constexpr int size = 32;

/// Facets side by side.
struct alignas(64) PressedFacets {
  VectorRow<size> corner[3];
  VectorRow<size> push;  ///< on the whole facet [N]
};

/// True where all lie in the window.
ENCASE_VECTOR_UNITS [[gnu::flatten]] bool find_pushes(PressedFacets& facets, int count,
                                                      double pressure, const HeightWindow& window)
{
  double out = 0.0;
#pragma omp simd reduction(+ : out)
  for (int n = 0; n < count; ++n) {
    facets.push.set(n, pressure * area_vector(facets.corner[0].at(n), facets.corner[1].at(n),
                                              facets.corner[2].at(n)));
    for (int i = 0; i < 3; ++i) {
      const double z = facets.corner[i].z[n];
      out += z >= window.low && z <= window.high ? 0.0 : 1.0;
    }
  }
  return out == 0.0;
}

}  // namespace

void add_pressure(const std::vector<Facet>& facet, const std::vector<Vec3>& position, int first,
                  int last, double pressure, const HeightWindow& window, std::vector<Vec3>& force)
{
  PressedFacets facets;
  for (; first < last; first += size) {
    const int count = std::min(size, last - first);
    for (int n = 0; n < count; ++n)
      for (int i = 0; i < 3; ++i) facets.corner[i].set(n, position[facet[first + n][i]]);
    const bool all_inside = find_pushes(facets, count, pressure, window);
    FacetPart part{1.0, Vec3::Constant(1.0 / 3.0)};
    for (int n = 0; n < count; ++n) {
      if (!all_inside)
        part = part_in_window({facets.corner[0].z[n], facets.corner[1].z[n], facets.corner[2].z[n]},
                              window);
      if (part.share == 0.0) continue;
      const Vec3 push = facets.push.at(n);
      for (int i = 0; i < 3; ++i) force[facet[first + n][i]] += part.weight(i) * push;
    }
  }
}

}  // namespace encased_column
