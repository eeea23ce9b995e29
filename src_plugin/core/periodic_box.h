// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <cmath>

namespace encased_column {

/// The box of a run, of which some directions may be periodic: what leaves at one side comes back
/// at the other, and everything stands there again and again, a length farther on.
struct PeriodicBox {
  Vec3 low = Vec3::Zero();     ///< [m]
  Vec3 length = Vec3::Zero();  ///< [m]
  bool periodic[3] = {false, false, false};

  /// Calls `visit(shift)` for each whole number of lengths that brings the point `x` [m] into the
  /// block from `from` to `to` [m]; where nothing is periodic, once, with zero.
  template <typename Visit>
  void for_images(const Vec3& x, const Vec3& from, const Vec3& to, const Visit& visit) const
  {
    int first[3] = {0, 0, 0}, last[3] = {0, 0, 0};
    for (int a = 0; a < 3; ++a) {
      if (!periodic[a]) continue;
      first[a] = static_cast<int>(std::ceil((from(a) - x(a)) / length(a)));
      last[a] = static_cast<int>(std::floor((to(a) - x(a)) / length(a)));
    }
    for (int k = first[2]; k <= last[2]; ++k)
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i)
          visit(Vec3(i * length(0), j * length(1), k * length(2)));
  }

  /// The image of `x` [m] that lies in the box.
  Vec3 wrapped(Vec3 x) const
  {
    for (int a = 0; a < 3; ++a)
      if (periodic[a]) x(a) -= length(a) * std::floor((x(a) - low(a)) / length(a));
    return x;
  }

  bool is_periodic() const { return periodic[0] || periodic[1] || periodic[2]; }
};

}  // namespace encased_column
