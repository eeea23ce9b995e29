// SPDX-License-Identifier: GPL-2.0-only
#include "shell/touched_nodes.h"

#include <algorithm>

namespace encased_column {

void TouchedNodes::mark(const std::vector<Facet>& facet, int first, int last,
                        const std::vector<int>& near)
{
  std::fill(is_mine_.begin(), is_mine_.end(), false);
  const auto mark_facet = [&](int f) {
    for (const int node : facet[f]) is_mine_[node] = true;
  };
  for (int f = first; f < last; ++f) mark_facet(f);
  for (const int f : near) mark_facet(f);
  mine_.clear();
  for (std::size_t i = 0; i < is_mine_.size(); ++i)
    if (is_mine_[i]) mine_.push_back(static_cast<double>(i));
}

std::size_t TouchedNodes::lay_out(const std::vector<double>& nodes_of_rank, int numbers_of_node)
{
  std::size_t count = 0;
  for (std::size_t r = 0; r < counts_.size(); ++r) {
    starts_[r] = static_cast<int>(count);
    counts_[r] = static_cast<int>(nodes_of_rank[r]) * numbers_of_node;
    count += counts_[r];
  }
  return count;
}

void TouchedNodes::take(const std::vector<Vec3>& load)
{
  double* row = own_.data();
  for (const double node : mine_) {
    const std::size_t i = static_cast<std::size_t>(node);
    as_vec3(row) = load[i];
    as_vec3(row + 3) = load[is_mine_.size() + i];
    row += numbers;
  }
}

void TouchedNodes::add_up(std::vector<Vec3>& load) const
{
  std::fill(load.begin(), load.end(), Vec3::Zero());
  const double* row = all_.data();
  for (const double node : node_) {
    const std::size_t i = static_cast<std::size_t>(node);
    load[i] += as_vec3(row);
    load[is_mine_.size() + i] += as_vec3(row + 3);
    row += numbers;
  }
}

}  // namespace encased_column
