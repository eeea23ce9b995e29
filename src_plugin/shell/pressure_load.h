#pragma once

#include "shell/height_window.h"
#include "shell/surface_mesh.h"

#include <algorithm>
#include <array>
#include <vector>

namespace encased_column {

/// Area times unit normal of a facet [m^2].
inline Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return 0.5 * (b - a).cross(c - a);
}

/// Adds the force of a pressure [Pa] that pushes facets [first, last) along their current normals,
/// where they lie in the window, to the nodal forces [N]. Negative pressure pushes against the
/// normals. For a whole facet each node takes p A / 3, which is the exact gradient of p times the
/// enclosed volume.
inline void add_pressure(const std::vector<Facet>& facet, const std::vector<Vec3>& position,
                         int first, int last, double pressure, const HeightWindow& window,
                         std::vector<Vec3>& force)
{
  for (int f = first; f < last; ++f) {
    const Facet& node = facet[f];
    const Vec3 &a = position[node[0]], &b = position[node[1]], &c = position[node[2]];
    const FacetPart part = part_in_window({a.z(), b.z(), c.z()}, window);
    if (part.share == 0.0) continue;
    const Vec3 push = pressure * area_vector(a, b, c);
    for (int i = 0; i < 3; ++i) force[node[i]] += part.weight(i) * push;
  }
}

/// Pressure that rises (or falls) linearly with the steps to its target and then stays.
class PressureRamp {
 public:
  explicit PressureRamp(double start) : from_(start), to_(start) {}

  /// Heads for `target` [Pa] over `steps` steps from `now` on, starting at the value of `now`.
  void set(double target, long steps, long now)
  {
    from_ = at(now);
    to_ = target;
    begin_ = now;
    steps_ = steps;
  }
  double at(long step) const
  {
    if (step >= begin_ + steps_) return to_;
    return from_ + (to_ - from_) * static_cast<double>(step - begin_) / static_cast<double>(steps_);
  }
  double target() const { return to_; }
  /// All there is to know of it, for a restart.
  static constexpr int numbers = 4;
  std::array<double, numbers> state() const
  {
    return {from_, to_, static_cast<double>(begin_), static_cast<double>(steps_)};
  }
  void restore(const std::array<double, numbers>& state)
  {
    from_ = state[0];
    to_ = state[1];
    begin_ = static_cast<long>(state[2]);
    steps_ = static_cast<long>(state[3]);
  }
  /// Steps until the target is reached.
  long steps_left(long now) const { return std::max(0L, begin_ + steps_ - now); }

 private:
  double from_, to_;
  long begin_ = 0, steps_ = 0;
};

}  // namespace encased_column
