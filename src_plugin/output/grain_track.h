// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/periodic_box.h"
#include "files/vtk_files.h"

#include <algorithm>
#include <vector>

namespace encased_column {

/// Where grains started from and how far they have turned since, kept through changes of their
/// order and of their rank.
class GrainTrack {
 public:
  static constexpr int values_per_grain = 6;

  void grow(int capacity)
  {
    start_.resize(3 * static_cast<std::size_t>(capacity), 0.0);
    rotation_.resize(3 * static_cast<std::size_t>(capacity), 0.0);
  }
  /// Grain i starts at `x` [m].
  void begin(int i, const double* x)
  {
    std::copy_n(x, 3, &start_[3 * i]);
    std::fill_n(&rotation_[3 * i], 3, 0.0);
  }
  void copy(int from, int to)
  {
    std::copy_n(&start_[3 * from], 3, &start_[3 * to]);
    std::copy_n(&rotation_[3 * from], 3, &rotation_[3 * to]);
  }
  /// The first `grains` turn with the `spin` [rad/s] for `time` [s].
  void turn(int grains, const double* spin, double time)
  {
    double* const __restrict rotation = rotation_.data();
    for (int k = 0; k < 3 * grains; ++k) rotation[k] += spin[k] * time;
  }

  const double* start(int i) const { return &start_[3 * i]; }        ///< [m]
  const double* rotation(int i) const { return &rotation_[3 * i]; }  ///< [rad]

  int pack(int i, double* buffer) const
  {
    std::copy_n(rotation(i), 3, std::copy_n(start(i), 3, buffer));
    return values_per_grain;
  }
  int unpack(int i, const double* buffer)
  {
    std::copy_n(buffer, 3, &start_[3 * i]);
    std::copy_n(buffer + 3, 3, &rotation_[3 * i]);
    return values_per_grain;
  }
  double bytes() const
  {
    return static_cast<double>(start_.capacity() + rotation_.capacity()) * sizeof(double);
  }

 private:
  // Apart: the rotation is added to in every step.
  std::vector<double> start_, rotation_;  ///< three numbers a grain
};

/// Neighbours for the strain, where the deck does not say: near enough to see a band some ten
/// diameters wide, and some tens of load-bearing grains.
constexpr double usual_strain_range = 1.5;  // mean diameters

/// Gives each of `grains` the deviatoric strain about it, of those within `range` [m] where
/// displacements start; a range below zero stands for the usual one.
void find_strains(std::vector<GrainRecord>& grains, double range, const PeriodicBox& box);

}  // namespace encased_column
