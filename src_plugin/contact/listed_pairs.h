#pragma once

#include "host/host_types.h"

#include "neigh_list.h"

#include <vector>

namespace encased_column {

/// The pairs of the host's list, one after the other: the list itself is a row a grain, most of
/// them so short that a loop's end comes as a surprise each time.
class ListedPairs {
 public:
  /// Pairs whose flags and memories lie one after the other in the host.
  struct Page {
    int begin, end;
    int* flags;
    double* memories;
  };

  /// Takes `list` over, whose contacts remember `numbers` numbers each, until the next is built.
  void take(const LAMMPS_NS::NeighList& list, int numbers)
  {
    first_.clear();
    second_.clear();
    pages_.clear();
    const LAMMPS_NS::NeighList& touches = *list.listgranhistory;
    for (int n = 0; n < list.inum; ++n) {
      const int i = list.ilist[n], count = list.numneigh[i];
      if (count == 0) continue;
      const int begin = static_cast<int>(first_.size());
      int* const flags = touches.firstneigh[i];
      double* const memories = touches.firstdouble[i];
      if (pages_.empty() || flags != pages_.back().flags + (begin - pages_.back().begin) ||
          memories != pages_.back().memories + (begin - pages_.back().begin) * numbers)
        pages_.push_back({begin, begin, flags, memories});
      for (int k = 0; k < count; ++k) {
        first_.push_back(i);
        second_.push_back(list.firstneigh[i][k] & NEIGHMASK);
      }
      pages_.back().end = begin + count;
    }
  }

  const std::vector<Page>& pages() const { return pages_; }
  const int* first() const { return first_.data(); }
  const int* second() const { return second_.data(); }

 private:
  std::vector<int> first_, second_;
  std::vector<Page> pages_;
};

}  // namespace encased_column
