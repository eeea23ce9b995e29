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
    rows.limit[i][n] = line.limit(memory.plastic_strain[i]);
    rows.origin[i][n] = line.origin;
    rows.tension[i][n] = line.tension;
    rows.slope[i][n] = line.slope;
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

/// Lets the facets [first, last) of a batch yield by their excess; returns the energy taken [J].
ENCASE_VECTOR_UNITS double ClothFacets::grow(ClothRows& rows, const double* area, int first,
                                             int last)
{
  double taken = 0.0;
  for (int i = 0; i < 2; ++i) {
#pragma omp simd reduction(+ : taken)
    for (int n = first; n < last; ++n) {
      const double growth = rows.excess[i][n] * rows.rate[i][n];
      const double plastic = rows.plastic_strain[i][n] + growth;
      const double limit = rows.tension[i][n] + rows.slope[i][n] * (plastic - rows.origin[i][n]);
      taken += 0.5 * area[n] * (rows.limit[i][n] + limit) * growth;
      rows.plastic_strain[i][n] = plastic;
      rows.limit[i][n] = limit;
    }
  }
  return taken;
}

void ClothFacets::advance(int first, int last, bool at_set_up)
{
  if (!remembers_) return;
  for (int f = first; f < last && !at_set_up;) {
    const int begin = f % facets_in_batch, end = std::min(facets_in_batch, begin + last - f);
    ClothRows& rows = rows_[f / facets_in_batch];
    if (rows.yields) dissipated_ += grow(rows, area_.data() + f - begin, begin, end);
    f += end - begin;
  }
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

ENCASE_VECTOR_UNITS bool ClothFacets::must_ask(int batch, int first, int last) const
{
  const ClothRows& rows = rows_[batch];
  if (!rows.yields) return false;
  int leaves = 0;
#pragma omp simd reduction(| : leaves)
  for (int n = first; n < last; ++n) leaves |= leaves_its_line(rows, n) ? 1 : 0;
  return leaves != 0;
}

void ClothFacets::ask(int batch, int first, int last, const ClothAnswers& answers)
{
  ClothRows& rows = rows_[batch];
  const auto& [hoop, axial, shear] = answers.force;
  for (int n = first; n < last; ++n) {
    if (!leaves_its_line(rows, n)) continue;
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
