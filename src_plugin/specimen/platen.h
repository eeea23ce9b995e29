// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <limits>

namespace encased_column {

/// Heights [m] between which something counts; by default all of them.
struct HeightWindow {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  double height() const { return high - low; }
  /// Level [m] at the part `part` [-] of the height, from below.
  double level(double part) const { return low + part * height(); }
  bool holds(double z) const { return z > low && z < high; }
  /// The third half way up: away from what the platens do to the stress.
  HeightWindow middle_third() const
  {
    const double third = height() / 3.0;
    return {low + third, high - third};
  }
  /// Level [m] of the center of sphere n of `count` that stand one above the other, from one that
  /// touches the lower end to one that touches the upper; a single one stands half way up.
  double level_in_stack(int n, int count, double radius) const
  {
    const double part = count > 1 ? static_cast<double>(n) / (count - 1) : 0.5;
    return HeightWindow{low + radius, high - radius}.level(part);
  }
};

/// A flat end of the specimen, across the z axis. Force, stress and work are of all ranks and to be
/// asked on all of them together.
class Platen {
 public:
  virtual ~Platen() = default;

  virtual bool is_top() const = 0;
  virtual double height() const = 0;  ///< of its face [m]
  virtual double speed() const = 0;   ///< towards the specimen [m/s]
  virtual double force() const = 0;   ///< with which the grains press on it [N]
  virtual double stress() const = 0;  ///< the same on the specimen's cross section [Pa]
  virtual double work() const = 0;    ///< it has done on the grains [J]
};

/// The two platens of a specimen.
struct Platens {
  const Platen* top = nullptr;
  const Platen* bottom = nullptr;

  /// Heights [m] between their faces.
  HeightWindow window() const { return {bottom->height(), top->height()}; }
  /// Speed [m/s] at which they approach each other.
  double closing_speed() const { return top->speed() + bottom->speed(); }
  double work() const { return top->work() + bottom->work(); }  ///< [J]
};

}  // namespace encased_column
