#include "shell/cloth_facets.h"

#include "shell/shell_element.h"

#include <limits>

namespace encased_column {

namespace {

/// Whether a force of [first, last) is above its limit; without branches, for the vector units.
bool is_above(const ClothAnswers& found, const ClothRows& rows, int first, int last)
{
  int above = 0;
  for (int n = first; n < last; ++n)
    above |= (found.force[0][n] > rows.limit[0][n]) | (found.force[1][n] > rows.limit[1][n]);
  return above != 0;
}

}  // namespace

ClothFacets::ClothFacets(const std::vector<ShellElement>& element, const Cloth& cloth)
    : cloth_(cloth),
      remembers_(cloth.yields()),
      memory_(element.size()),
      rows_((element.size() + facets_in_batch - 1) / facets_in_batch)
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
    set_memory(f, memory_[f]);
  }
}

void ClothFacets::set_memory(int f, const FacetMemory& memory)
{
  memory_[f] = memory;
  ClothRows& rows = rows_[f / facets_in_batch];
  const int n = f % facets_in_batch;
  const double left = memory.left();
  rows.left[n] = left;
  rows.slip[n] = memory.slip;
  if (left < 1.0) rows.torn = true;
  constexpr double always = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < 2; ++i) {
    rows.plastic_strain[i][n] = memory.plastic_strain[i];
    rows.limit[i][n] = left == 1.0  ? cloth_.limit(i, facet_[f], memory)
                       : left > 0.0 ? always
                                    : -always;
  }
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

void ClothFacets::ask(int batch, int first, int last, const ClothAnswers& answers)
{
  const ClothRows& rows = rows_[batch];
  if (!remembers_ || !is_above(answers, rows, first, last)) return;
  const auto& [hoop, axial, shear] = answers.force;
  for (int n = first; n < last; ++n) {
    if (!(hoop[n] > rows.limit[0][n]) && !(axial[n] > rows.limit[1][n])) continue;
    const int f = batch * facets_in_batch + n;
    Wish wish{f, memory_[f], 0.0};
    const ClothAnswer answer{
        {hoop[n], axial[n], shear[n]}, answers.elastic_shear[n], answers.energy[n] / area_[f]};
    wish.taken = area_[f] * cloth_.follow(answer, facet_[f], wish.memory);
    wish_.push_back(wish);
  }
}

}  // namespace encased_column
