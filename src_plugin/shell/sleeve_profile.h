// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/shell_model.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace encased_column {

/// A sleeve at one height, means over its ring of nodes.
struct ProfilePoint {
  double z = 0.0;             ///< [m]
  double radius = 0.0;        ///< about the axis [m]
  double before = 0.0;        ///< radius of the same nodes in the state compared with [m]
  double hoop_tension = 0.0;  ///< of the facets around, by area [N/m]
};

/// The rings of a sleeve: nodes whose heights, without load, fall into the same of equal slices. Of
/// a generated cylinder each ring of nodes is one.
class SleeveRings {
 public:
  explicit SleeveRings(const ShellModel& model)
  {
    double low = 1e300, high = -1e300, area = 0.0;
    for (const Vec3& x : model.reference()) {
      low = std::min(low, x.z());
      high = std::max(high, x.z());
    }
    for (const ShellElement& element : model.element()) area += element.area();
    // Equilateral facets of area A are sqrt(sqrt(3) A) high.
    const double row = std::sqrt(std::sqrt(3.0) * area / model.facets());
    // A tube far thinner than a facet is long has more rows than nodes.
    const double rows = std::clamp(std::round((high - low) / row), 1.0, 1.0 * model.nodes());
    rings_ = 1 + static_cast<int>(rows);
    for (const Vec3& x : model.reference())
      ring_.push_back(static_cast<int>(std::lround((x.z() - low) / (high - low) * (rings_ - 1))));
  }

  /// Means from bottom to top; `before` holds the positions to compare with, `axis` the center
  /// line. A slice without nodes is left out.
  std::vector<ProfilePoint> profile(const ShellModel& model, const std::vector<Vec3>& before,
                                    const Vec3& axis) const
  {
    std::vector<ProfilePoint> rings(rings_);
    std::vector<double> nodes(rings_, 0.0), area(rings_, 0.0);
    for (int i = 0; i < model.nodes(); ++i) {
      const Vec3& x = model.position()[i];
      ProfilePoint& ring = rings[ring_[i]];
      nodes[ring_[i]] += 1.0;
      ring.z += x.z();
      ring.radius += std::hypot(x.x() - axis.x(), x.y() - axis.y());
      ring.before += std::hypot(before[i].x() - axis.x(), before[i].y() - axis.y());
    }
    for (int f = 0; f < model.facets(); ++f) {
      const double tension = model.facet_state(f).membrane_force(0);
      for (const int node : model.facet()[f]) {
        area[ring_[node]] += model.element()[f].area();
        rings[ring_[node]].hoop_tension += model.element()[f].area() * tension;
      }
    }
    std::vector<ProfilePoint> out;
    for (int r = 0; r < rings_; ++r) {
      if (nodes[r] == 0.0) continue;
      ProfilePoint ring = rings[r];
      ring.z /= nodes[r];
      ring.radius /= nodes[r];
      ring.before /= nodes[r];
      ring.hoop_tension /= area[r];
      out.push_back(ring);
    }
    return out;
  }

 private:
  int rings_ = 0;
  std::vector<int> ring_;  ///< of each node
};

}  // namespace encased_column
