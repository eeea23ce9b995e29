// SPDX-License-Identifier: GPL-2.0-only
// Vectors of three spread over the halves of a vector register would keep rows of them from it.
// Nothing here may depend on how Eigen aligns larger matrices, which this changes.
#define EIGEN_DONT_VECTORIZE

#include "core/vector_units.h"
#include "shell/facet_batches.h"
#include "shell/facet_loads.h"

#include <algorithm>

namespace encased_column {

/// A facet of a batch, read like a FacetReference.
struct FacetBatches::InBatch {
  const Batch& batch;
  int n;
  double bending_left = 1.0;
  double area = batch.area[n];

  double gradient(int axis, int node) const { return batch.gradient[2 * axis + node - 1][n]; }
  double bending(int i, int j) const { return batch.bending[place(i, j)][n]; }
};

/// The normal as each node has turned it: v + 2 w (q x v) + 2 q x (q x v) for the quaternion (q,
/// w).
FacetVectors FacetBatches::directors(const Batch& batch, int n) const
{
  const Vec3 normal = batch.normal.at(n);
  const auto turned = [&](const RotationRow& rotation) -> Vec3 {
    const Vec3 q = rotation.vector.at(n), twice = 2.0 * q.cross(normal);
    return normal + rotation.scalar[n] * twice + q.cross(twice);
  };
  return {turned(rotation_[0]), turned(rotation_[1]), turned(rotation_[2])};
}

// A function of its own: what is declared in the loop itself would stay in memory.
double FacetBatches::resolve_one(const Batch& batch, int n)
{
  const auto membrane = [this](const PlaneVector& strain) -> MembraneAnswer {
    return {strain, strain(0) * membrane_.col(0) + strain(1) * membrane_.col(1) +
                        strain(2) * membrane_.col(2)};
  };
  const FacetVectors x{position_[0].at(n), position_[1].at(n), position_[2].at(n)};
  const FacetVectors d = directors(batch, n);
  const FacetLoads loads = facet_loads<true>(InBatch{batch, n}, x, d, membrane);
  for (int i = 0; i < 3; ++i) {
    force_[i].set(n, loads.force[i]);
    moment_[i].set(n, loads.moment[i]);
  }
  return loads.energy;
}

// Flat: a call would keep the loop from the vector units.
ENCASE_VECTOR_UNITS [[gnu::flatten]] double FacetBatches::resolve(const Batch& batch, int first,
                                                                  int last)
{
  double energy = 0.0;
#pragma omp simd reduction(+ : energy)
  for (int n = first; n < last; ++n) energy += resolve_one(batch, n);
  return energy;
}

template <bool bends, bool wrinkles, bool softens, FacetBatches::Remembers remembers>
double FacetBatches::resolve_one_cloth(const Batch& batch, ClothRows& rows,
                                       const EvenStiffness& whole, int n)
{
  constexpr bool yields = remembers != Remembers::nothing, all = remembers == Remembers::all;
  const double left = all ? rows.left[n] : 1.0;
  // Number by number: copies of vectors would stay in memory.
  const auto membrane = [&](const PlaneVector& strain) -> MembraneAnswer {
    const double hoop = yields ? strain(0) - rows.plastic_strain[0][n] : strain(0);
    const double axial = yields ? strain(1) - rows.plastic_strain[1][n] : strain(1);
    const double shear = all ? strain(2) - rows.slip[n] : strain(2);
    const PlaneVector force = relaxed_force<wrinkles, softens>(whole, {hoop, axial, shear});
    const double force_hoop = all ? left * force(0) : force(0);
    const double force_axial = all ? left * force(1) : force(1);
    const double force_shear = all ? left * force(2) : force(2);
    if constexpr (yields) {
      auto& excess = remembers == Remembers::growing ? rows.excess : excess_;
      excess[0][n] = positive_part(force_hoop - rows.limit[0][n]);
      excess[1][n] = positive_part(force_axial - rows.limit[1][n]);
    }
    if constexpr (all) {
      answers_.force[0][n] = force_hoop;
      answers_.force[1][n] = force_axial;
      answers_.force[2][n] = force_shear;
      answers_.elastic_shear[n] = shear;
    }
    return {{hoop, axial, shear}, {force_hoop, force_axial, force_shear}};
  };
  const FacetVectors x{position_[0].at(n), position_[1].at(n), position_[2].at(n)};
  const FacetVectors d = directors(batch, n);
  const FacetLoads loads = facet_loads<bends>(InBatch{batch, n, left}, x, d, membrane);
  if constexpr (all) answers_.energy[n] = loads.energy;
  for (int i = 0; i < 3; ++i) {
    force_[i].set(n, loads.force[i]);
    moment_[i].set(n, loads.moment[i]);
  }
  return loads.energy;
}

template <bool bends, bool wrinkles, bool softens, FacetBatches::Remembers remembers>
ENCASE_VECTOR_UNITS [[gnu::flatten]] double FacetBatches::resolve_cloth_as(const Batch& batch,
                                                                           ClothRows& rows,
                                                                           int first, int last)
{
  const EvenStiffness whole = cloth_.whole();
  constexpr bool grows = remembers == Remembers::growing, yields = remembers != Remembers::nothing;
  double energy = 0.0, excess = 0.0, taken = 0.0, leaving = 0.0;
#pragma omp simd reduction(+ : energy, excess, taken, leaving)
  for (int n = first; n < last; ++n) {
    if constexpr (grows) taken += batch.area[n] * (rows.grow(0, n) + rows.grow(1, n));
    energy += resolve_one_cloth<bends, wrinkles, softens, remembers>(batch, rows, whole, n);
    if constexpr (grows) {
      excess += rows.excess[0][n] + rows.excess[1][n];
      leaving += rows.leaves_its_line(n) ? 1.0 : 0.0;
    } else if constexpr (yields) {
      excess += excess_[0][n] + excess_[1][n];
    }
  }
  if constexpr (yields && !grows)
    if (excess > 0.0 || rows.yields)  // else the rows have zeros, too
      for (int i = 0; i < 2; ++i)
        std::copy(excess_[i] + first, excess_[i] + last, rows.excess[i] + first);
  rows.yields = excess > 0.0 || (rows.yields && last - first < size);
  if constexpr (grows) cloth_.dissipate(taken);
  // Few batches yield: of the others it is found by itself where one begins to.
  must_ask_ = grows ? leaving > 0.0 : rows.yields && cloth_.must_ask(rows, first, last);
  return energy;
}

template <bool bends, bool wrinkles, bool softens>
double FacetBatches::resolve_cloth_kind(const Batch& batch, int number, int first, int last,
                                        bool at_set_up)
{
  ClothRows& rows = cloth_.rows(number);
  if (!cloth_.remembers())
    return resolve_cloth_as<bends, wrinkles, softens, Remembers::nothing>(batch, rows, first, last);
  const bool grows = rows.yields && !at_set_up;
  double energy = 0.0;
  if (rows.torn) {
    if (grows) cloth_.grow(number, first, last);
  } else if (grows) {
    energy =
        resolve_cloth_as<bends, wrinkles, softens, Remembers::growing>(batch, rows, first, last);
  } else {
    energy = resolve_cloth_as<bends, wrinkles, softens, Remembers::plastic_strain>(batch, rows,
                                                                                   first, last);
  }
  // Again where somebody has to tell how it stands: the loads come out the same.
  if (rows.torn || must_ask_) {
    energy = resolve_cloth_as<bends, wrinkles, softens, Remembers::all>(batch, rows, first, last);
    cloth_.ask(number, first, last, answers_);
  }
  return energy;
}

double FacetBatches::resolve_cloth(const Batch& batch, int number, int first, int last,
                                   bool at_set_up)
{
  if (!wrinkles_)
    return bends_ ? resolve_cloth_kind<true, false, true>(batch, number, first, last, at_set_up)
                  : resolve_cloth_kind<false, false, true>(batch, number, first, last, at_set_up);
  if (!cloth_.softens_off_axis())
    return bends_ ? resolve_cloth_kind<true, true, false>(batch, number, first, last, at_set_up)
                  : resolve_cloth_kind<false, true, false>(batch, number, first, last, at_set_up);
  return bends_ ? resolve_cloth_kind<true, true, true>(batch, number, first, last, at_set_up)
                : resolve_cloth_kind<false, true, true>(batch, number, first, last, at_set_up);
}

}  // namespace encased_column
