// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vector_units.h"
#include "shell/cloth_facets.h"
#include "shell/surface_mesh.h"

#include <array>
#include <vector>

namespace encased_column {

class ShellElement;
class ShellMaterial;

/// The facets of a sleeve side by side, so that the vector units of the machine see to several at
/// once: facet_loads() of each, for a membrane that bends and for any cloth.
class FacetBatches {
 public:
  static constexpr int size = facets_in_batch;

  FacetBatches() = default;
  FacetBatches(const std::vector<Facet>& facet, const std::vector<ShellElement>& element,
               const ShellMaterial& material);

  /// Adds the loads of facets [first, last) to the forces [N] and moments [N m] of the nodes, in
  /// the order of the facets; returns their energy [J]. Rotations are unit quaternions (x, y, z,
  /// w). Of a cloth see ClothFacets for what is advanced before, unless `at_set_up`.
  double add_loads(int first, int last, bool at_set_up, const Vec3* position,
                   const double* rotation, Vec3* force, Vec3* moment);

  ClothFacets& cloth() { return cloth_; }
  const ClothFacets& cloth() const { return cloth_; }

 private:
  // One of the files behind this one keeps Eigen from aligning matrices: these have nothing to
  // align.
  static_assert(alignof(Vec3) == alignof(double) && alignof(Mat3) == alignof(double));

  using Numbers = double[size];
  static constexpr int symmetric = 21;  ///< numbers of a symmetric 6 x 6 matrix
  /// Place of (i, j) among them.
  static constexpr int place(int i, int j)
  {
    return i < j ? j * (j + 1) / 2 + i : i * (i + 1) / 2 + j;
  }
  struct alignas(64) Batch {
    Facet node[size];
    VectorRow<size> normal;
    Numbers area, gradient[4], bending[symmetric];
  };
  struct InBatch;
  /// Quaternions of nodes.
  struct RotationRow {
    VectorRow<size> vector;
    Numbers scalar;
  };

  std::array<Vec3, 3> directors(const Batch& batch, int n) const;
  double resolve(const Batch& batch, int first, int last);
  double resolve_one(const Batch& batch, int n);
  double resolve_cloth(const Batch& batch, int number, int first, int last, bool at_set_up);
  /// What of its memory a cloth's loads look at; `growing`: the plastic strain, once it has grown.
  enum class Remembers { nothing, plastic_strain, growing, all };
  template <bool bends, bool wrinkles, bool softens>
  double resolve_cloth_kind(const Batch& batch, int number, int first, int last, bool at_set_up);
  template <bool bends, bool wrinkles, bool softens, Remembers remembers>
  double resolve_cloth_as(const Batch& batch, ClothRows& rows, int first, int last);
  template <bool bends, bool wrinkles, bool softens, Remembers remembers>
  double resolve_one_cloth(const Batch& batch, ClothRows& rows, const EvenStiffness& whole, int n);

  std::vector<Batch> batches_;
  Mat3 membrane_;
  bool is_cloth_ = false, bends_ = false, wrinkles_ = false;
  ClothFacets cloth_;
  bool must_ask_ = false;  ///< some facet of the batch at hand, see ClothFacets
  /// Of the nodes of the batch at hand: in, then out.
  alignas(64) VectorRow<size> position_[3], force_[3], moment_[3];
  alignas(64) RotationRow rotation_[3];
  // Of its facets:
  alignas(64) Numbers excess_[2];     ///< where none was before, as in ClothRows
  alignas(64) ClothAnswers answers_;  ///< where they remember all
};

}  // namespace encased_column
