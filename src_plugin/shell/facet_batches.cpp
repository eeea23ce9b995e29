// SPDX-License-Identifier: GPL-2.0-only
#include "shell/facet_batches.h"

#include "shell/shell_element.h"

#include <algorithm>

namespace encased_column {

namespace {

/// Fetches one of 32 parts of the first `bytes` of something large into the cache.
void fetch(const void* large, std::size_t bytes, int part)
{
  constexpr std::size_t line = 64;  // bytes
  for (std::size_t at = part * line; at < bytes; at += facets_in_batch * line)
    __builtin_prefetch(static_cast<const char*>(large) + at);
}

}  // namespace

FacetBatches::FacetBatches(const std::vector<Facet>& facet,
                           const std::vector<ShellElement>& element, const ShellMaterial& material)
    : batches_((facet.size() + size - 1) / size),
      membrane_(material.membrane()),
      is_cloth_(material.is_cloth()),
      bends_(material.bends()),
      wrinkles_(material.constants().tension_only)
{
  if (is_cloth_) cloth_ = ClothFacets(element, material.cloth());
  for (std::size_t f = 0; f < facet.size(); ++f) {
    Batch& batch = batches_[f / size];
    const std::size_t n = f % size;
    const FacetReference& reference = element[f].reference();
    batch.node[n] = facet[f];
    batch.normal.set(n, element[f].normal());
    batch.area[n] = reference.area;
    for (int k = 0; k < 4; ++k) batch.gradient[k][n] = reference.gradient(k / 2, 1 + k % 2);
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j <= i; ++j) batch.bending[place(i, j)][n] = reference.bending(i, j);
  }
}

double FacetBatches::add_loads(int first, int last, bool at_set_up, const Vec3* position,
                               const double* rotation, Vec3* force, Vec3* moment)
{
  cloth_.advance(first, last, at_set_up);
  double energy = 0.0;
  for (int f = first; f < last;) {
    const Batch& batch = batches_[f / size];
    const int begin = f % size, end = std::min(size, begin + last - f);
    const int next = f / size + 1;
    const bool is_last = next == static_cast<int>(batches_.size());
    for (int n = begin; n < end; ++n) {
      // The batches lie in a long row that does not stay in the cache from step to step.
      if (!is_last) {
        fetch(&batches_[next], sizeof(Batch), n);
        if (cloth_.remembers()) fetch(&cloth_.rows(next), cloth_.rows(next).in_use(), n);
      }
      for (int i = 0; i < 3; ++i) {
        const int node = batch.node[n][i];
        position_[i].set(n, position[node]);
        rotation_[i].vector.set(n, as_vec3(rotation + 4 * node));
        rotation_[i].scalar[n] = rotation[4 * node + 3];
      }
    }
    energy += is_cloth_ ? resolve_cloth(batch, f / size, begin, end, at_set_up)
                        : resolve(batch, begin, end);
    for (int n = begin; n < end; ++n)
      for (int i = 0; i < 3; ++i) {
        const int node = batch.node[n][i];
        force[node] += force_[i].at(n);
        moment[node] += moment_[i].at(n);
      }
    f += end - begin;
  }
  return energy;
}

}  // namespace encased_column
