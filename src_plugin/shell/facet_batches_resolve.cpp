// Vectors of three spread over the halves of a vector register would keep rows of them from it.
// Nothing here may depend on how Eigen aligns larger matrices, which this changes.
#define EIGEN_DONT_VECTORIZE

#include "core/vector_units.h"
#include "shell/facet_batches.h"
#include "shell/facet_loads.h"

namespace encased_column {

/// A facet of a batch, read like a FacetReference.
struct FacetBatches::InBatch {
  const Batch& batch;
  int n;
  double area = batch.area[n];

  double gradient(int axis, int node) const { return batch.gradient[2 * axis + node - 1][n]; }
  double bending(int i, int j) const { return batch.bending[place(i, j)][n]; }
};

// A function of its own: what is declared in the loop itself would stay in memory.
double FacetBatches::resolve_one(const Batch& batch, int n)
{
  const auto membrane_force = [this](const PlaneVector& strain) -> PlaneVector {
    return strain(0) * membrane_.col(0) + strain(1) * membrane_.col(1) +
           strain(2) * membrane_.col(2);
  };
  const FacetVectors x{position_[0].at(n), position_[1].at(n), position_[2].at(n)};
  const FacetVectors d{director_[0].at(n), director_[1].at(n), director_[2].at(n)};
  const FacetLoads loads = facet_loads<true>(InBatch{batch, n}, x, d, membrane_force);
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

}  // namespace encased_column
