// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/surface_mesh.h"

#include <vector>

namespace encased_column {

/// The facets of a tube that stands along z, sorted by height into bands about as high as one of
/// them, with the room in the middle of each that no facet reaches into.
class HeightBands {
 public:
  /// Sorts the facets as they lie now.
  HeightBands(const std::vector<Facet>& facet, const std::vector<Vec3>& position);

  int size() const { return static_cast<int>(bands_.size()); }
  /// The band of the height `z` [m], the first or last one beyond the ends.
  int band_of(double z) const;
  /// Height [m] at the part 0 to 1 of a band.
  double height_in(int band, double part) const { return low_ + (band + part) * height_; }
  const std::vector<int>& facets(int band) const { return bands_[band].facets; }
  /// The middle of a band, half way up [m].
  Vec3 middle(int band) const { return {bands_[band].x, bands_[band].y, height_in(band, 0.5)}; }

  /// True where `point` lies in the cylinder about the middle of its band that is free of facets.
  bool is_in_free_middle(const Vec3& point, int band) const
  {
    return square_distance(bands_[band], point) < bands_[band].free * bands_[band].free;
  }
  /// True where no facet comes within `reach` [m] of `point`; false may be wrong.
  bool is_clear(const Vec3& point, double reach) const;

 private:
  struct Band {
    std::vector<int> facets;
    double x = 0.0, y = 0.0;  ///< [m]
    double free = 0.0;        ///< radius about (x, y) that no facet reaches into [m]
  };

  static double square_distance(const Band& band, const Vec3& point);
  static void free_middle(Band& band, const std::vector<Facet>& facet,
                          const std::vector<Vec3>& position);

  double low_ = 0.0, height_ = 1.0;  ///< lower end, and height of a band [m]
  std::vector<Band> bands_;
};

}  // namespace encased_column
