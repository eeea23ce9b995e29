// SPDX-License-Identifier: GPL-2.0-only
// Vectors of three spread over the halves of a vector register would keep rows of them from it.
#define EIGEN_DONT_VECTORIZE

#include "shell/pressure_load.h"

#include "core/vector_units.h"

#include <algorithm>

namespace encased_column {

namespace {

/// What pushes each facet as a whole [N]; true where all lie in the window.
ENCASE_VECTOR_UNITS [[gnu::flatten]] bool find_pushes(const PressedRow (&corner)[3], int first,
                                                      int last, double pressure,
                                                      const HeightWindow& window, PressedRow& push)
{
  double out = 0.0;
#pragma omp simd reduction(+ : out)
  for (int n = first; n < last; ++n) {
    push.set(n, pressure * area_vector(corner[0].at(n), corner[1].at(n), corner[2].at(n)));
    for (int i = 0; i < 3; ++i)
      out += corner[i].z[n] >= window.low && corner[i].z[n] <= window.high ? 0.0 : 1.0;
  }
  return out == 0.0;
}

}  // namespace

void press_row(const PressedRow (&corner)[3], const Facet* facet, int first, int last,
               const PressedNodes& pressed)
{
  alignas(64) PressedRow pushes;
  const bool all_inside =
      find_pushes(corner, first, last, pressed.pressure, pressed.window, pushes);
  FacetPart part{1.0, Vec3::Constant(1.0 / 3.0)};
  for (int n = first; n < last; ++n) {
    if (!all_inside)
      part = part_in_window({corner[0].z[n], corner[1].z[n], corner[2].z[n]}, pressed.window);
    if (part.share == 0.0) continue;
    const Vec3 push = pushes.at(n);
    for (int i = 0; i < 3; ++i) pressed.force[facet[n][i]] += part.weight(i) * push;
  }
}

void add_pressure(const std::vector<Facet>& facet, const std::vector<Vec3>& position, int first,
                  int last, double pressure, const HeightWindow& window, std::vector<Vec3>& force)
{
  alignas(64) PressedRow corner[3];
  for (; first < last; first += pressed_at_once) {
    const int count = std::min(pressed_at_once, last - first);
    for (int n = 0; n < count; ++n)
      for (int i = 0; i < 3; ++i) corner[i].set(n, position[facet[first + n][i]]);
    press_row(corner, &facet[first], 0, count, {pressure, window, force.data()});
  }
}

}  // namespace encased_column
