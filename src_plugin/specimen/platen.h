#pragma once

#include "specimen/height_window.h"

namespace encased_column {

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
