#pragma once

#include <array>
#include <optional>

namespace encased_column {

/// Heights [m] of the two platens.
struct PlatenHeights {
  double bottom, top;
};

/// Where the platens stand that began at 0 and `built` and were `first` apart before shear and
/// `now` after a part of it, all [m]. `moving` is the decks' variable: 0 the lower one moves, 1 the
/// upper one; with 2 the lower one moves before shear, and both by halves during it.
inline PlatenHeights platen_heights(double built, double first, double now, int moving)
{
  if (moving == 1) return {0.0, now};
  const double bottom = built - (moving == 0 ? now : 0.5 * (first + now));
  return {bottom, bottom + now};
}

/// The walls around grains: platens, and a cylinder about the z axis where there is one.
struct WallPlaces {
  PlatenHeights platens;
  std::optional<double> radius;  ///< [m]
};

/// Whether a grain whose center [m] this is has left through a wall. A grain on a wall overlaps it,
/// so that its surface sticks out; with its center beyond, nothing pushes it back.
inline bool is_outside(const std::array<double, 3>& center, const WallPlaces& walls)
{
  const auto& [x, y, z] = center;
  if (z < walls.platens.bottom || z > walls.platens.top) return true;
  return walls.radius && x * x + y * y > *walls.radius * *walls.radius;
}

}  // namespace encased_column
