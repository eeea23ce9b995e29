// SPDX-License-Identifier: GPL-2.0-only
#include "shell/cloth_facets.h"

#include "core/vector_units.h"
#include "shell/shell_element.h"

#include <algorithm>

namespace encased_column {

ClothFacets::ClothFacets(const std::vector<ShellElement>& element, const Cloth& cloth)
    : cloth_(cloth),
      remembers_(cloth.yields()),
      memory_(element.size()),
      rows_((element.size() + facets_in_batch - 1) / facets_in_batch, ClothRows{})
{
  for (const ShellElement& e : element) {
    facet_.push_back({e.tear_widths(), {1.0, 1.0}});
    cloth_.require_no_snap_back(facet_.back());
    area_.push_back(e.area());
  }
  if (remembers_) wish_.reserve(element.size());
  for (std::size_t f = 0; f < element.size(); ++f) set_memory(static_cast<int>(f), {});
}

void ClothFacets::weaken(const std::vector<int>& facets, double share)
{
  for (const int f : facets) {
    facet_[f].strength[0] = share;
    set_memory(f, memory(f));
  }
}

void ClothFacets::set_memory(int f, const FacetMemory& memory)
{
  memory_[f] = memory;
  ClothRows& rows = rows_[f / facets_in_batch];
  const int n = f % facets_in_batch;
  rows.left[n] = memory.left();
  rows.slip[n] = memory.slip;
  if (memory.left() < 1.0) rows.torn = true;
  for (int i = 0; i < 2; ++i) {
    const YieldLine line = cloth_.line(i, facet_[f], memory);
    rows.plastic_strain[i][n] = memory.plastic_strain[i];
    rows.start[i][n] = line.tension - line.slope * line.origin;
    rows.slope[i][n] = line.slope;
    rows.limit[i][n] = rows.limit_at(i, n, memory.plastic_strain[i]);
    rows.end[i][n] = line.end;
    rows.rate[i][n] = cloth_.growth_rate(i, line);
  }
}

FacetMemory ClothFacets::memory(int f) const
{
  FacetMemory memory = memory_[f];
  for (int i = 0; i < 2; ++i)
    memory.plastic_strain[i] = rows_[f / facets_in_batch].plastic_strain[i][f % facets_in_batch];
  return memory;
}

ENCASE_VECTOR_UNITS void ClothFacets::grow(int batch, int first, int last)
{
  ClothRows& rows = rows_[batch];
  const double* area = area_.data() + batch * facets_in_batch;
  double taken = 0.0;
#pragma omp simd reduction(+ : taken)
  for (int n = first; n < last; ++n) taken += area[n] * (rows.grow(0, n) + rows.grow(1, n));
  dissipated_ += taken;
}

void ClothFacets::advance(int first, int last, bool at_set_up)
{
  std::size_t kept = 0;
  for (const Wish& wish : wish_) {
    if (wish.facet < first || wish.facet >= last) {
      wish_[kept++] = wish;
      continue;
    }
    if (at_set_up) continue;
    set_memory(wish.facet, wish.memory);
    dissipated_ += wish.taken;
  }
  wish_.erase(wish_.begin() + static_cast<long>(kept), wish_.end());
}

ENCASE_VECTOR_UNITS bool ClothFacets::must_ask(const ClothRows& rows, int first, int last)
{
  int leaves = 0;
#pragma omp simd reduction(| : leaves)
  for (int n = first; n < last; ++n) leaves |= rows.leaves_its_line(n) ? 1 : 0;
  return leaves != 0;
}

void ClothFacets::ask(int batch, int first, int last, const ClothAnswers& answers)
{
  ClothRows& rows = rows_[batch];
  const auto& [hoop, axial, shear] = answers.force;
  for (int n = first; n < last; ++n) {
    if (!rows.leaves_its_line(n)) continue;
    rows.excess[0][n] = rows.excess[1][n] = 0.0;
    const int f = batch * facets_in_batch + n;
    Wish wish{f, memory(f), 0.0};
    const ClothAnswer answer{
        {hoop[n], axial[n], shear[n]}, answers.elastic_shear[n], answers.energy[n] / area_[f]};
    wish.taken = area_[f] * cloth_.follow(answer, facet_[f], wish.memory);
    wish_.push_back(wish);
  }
}

}  // namespace encased_column
