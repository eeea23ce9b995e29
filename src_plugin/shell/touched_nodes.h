// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/surface_mesh.h"

#include <vector>

namespace encased_column {

/// Which nodes the ranks load: those of a rank's facets, and of facets near its grains. A sum over
/// the ranks carries only these, and comes out the same on all: in the order of the ranks. Where
/// many ranks touch the same nodes, in all more than twice those there are, a sum of all nodes,
/// which sends each number twice, carries less.
///
/// `ranks.gather(mine, counts, starts, all)` makes numbers of all ranks known to each: `counts[r]`
/// of rank r, from `starts[r]` on in `all`; `ranks.sum(numbers, count)` adds up in place.
class TouchedNodes {
 public:
  TouchedNodes() = default;
  TouchedNodes(int nodes, int ranks) : is_mine_(nodes), counts_(ranks), starts_(ranks) {}

  /// Lists the nodes of facets [first, last) and of those `near`, and those of all other ranks.
  template <typename Ranks>
  void list(const std::vector<Facet>& facet, int first, int last, const std::vector<int>& near,
            const Ranks& ranks)
  {
    mark(facet, first, last, near);
    const double count = static_cast<double>(mine_.size());
    std::vector<double> count_of_rank(counts_.size());
    lay_out(std::vector<double>(counts_.size(), 1.0), 1);
    ranks.gather(&count, counts_.data(), starts_.data(), count_of_rank.data());
    node_.resize(lay_out(count_of_rank, 1));
    ranks.gather(mine_.data(), counts_.data(), starts_.data(), node_.data());
    few_ = node_.size() <= 2 * is_mine_.size();
    own_.resize(mine_.size() * numbers);
    all_.resize(lay_out(count_of_rank, numbers));
  }

  /// Adds `load` up: forces of all nodes [N], then moments [N m]. Allocates no memory.
  template <typename Ranks>
  void sum(std::vector<Vec3>& load, const Ranks& ranks)
  {
    if (!few_) return ranks.sum(load.front().data(), 3 * load.size());
    take(load);
    ranks.gather(own_.data(), counts_.data(), starts_.data(), all_.data());
    add_up(load);
  }

 private:
  static constexpr int numbers = 6;  ///< of a node: force and moment

  void mark(const std::vector<Facet>& facet, int first, int last, const std::vector<int>& near);
  /// Rows of so many numbers for each of a rank's nodes, rank after rank; returns their number.
  std::size_t lay_out(const std::vector<double>& nodes_of_rank, int numbers_of_node);
  void take(const std::vector<Vec3>& load);
  void add_up(std::vector<Vec3>& load) const;

  bool few_ = true;
  std::vector<bool> is_mine_;
  std::vector<double> mine_, node_;  ///< nodes of this rank, of all: numbers like what is gathered
  std::vector<int> counts_, starts_;
  std::vector<double> own_, all_;  ///< loads
};

}  // namespace encased_column
