// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/periodic_box.h"
#include "files/column.h"
#include "measure/measuring_sphere.h"
#include "measure/seen_contact.h"
#include "specimen/platen.h"

#include <vector>

namespace encased_column {

class Options;

/// One row of the table: a sphere at one step.
struct SphereRow {
  double step, number;  ///< spheres count from 1
  MeasuringSphere sphere;
  SphereMeasure measure;
  double largest_force;  ///< [N]
};

/// Its columns, in their order.
const std::vector<Column<SphereRow>>& sphere_columns();

/// Several measuring spheres, some of which stand still and some one above the other between two
/// heights, and what grains and contacts add up to in them. In a periodic box each image counts.
class SphereSampler {
 public:
  SphereSampler() = default;
  /// As the keywords `sphere`, `stack`, `platens` and `axis` say; throws InputError.
  explicit SphereSampler(const Options& options);

  bool has_stack() const { return stack_ > 0; }
  std::size_t spheres() const { return spheres_.size(); }

  /// Begins a sample; the lowest and the uppermost sphere of the stack touch the ends of `window`.
  void start(const PeriodicBox& box, const HeightWindow& window);
  void add(const SeenContact& contact);
  /// A grain at `x` [m] with so many contacts.
  void add_grain(const Vec3& x, double radius, int contacts);

  /// What adds up over ranks, and where the largest counts.
  double* sums() { return &sums_.front().solid; }
  std::size_t size_of_sums() const { return sums_.size() * sizeof(SphereSums) / sizeof(double); }
  std::vector<double>& largest_forces() { return largest_force_; }

  /// Once all ranks have added.
  std::vector<SphereRow> samples(double step) const;

 private:
  void place_stack(const HeightWindow& window);
  template <typename Visit>
  void for_images(const MeasuringSphere& sphere, const Vec3& x, double reach,
                  const Visit& visit) const;

  std::vector<MeasuringSphere> spheres_;  ///< those that stand still, then the stack
  std::size_t stack_ = 0;                 ///< number of those in the stack
  PeriodicBox box_;
  std::vector<SphereSums> sums_;
  std::vector<double> largest_force_;  ///< [N]
};

}  // namespace encased_column
