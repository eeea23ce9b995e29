// SPDX-License-Identifier: GPL-2.0-only
#pragma once

namespace LAMMPS_NS {
class PairGran;
}

#include "contact/grain_grid.h"
#include "host/host_types.h"

#include "neigh_list.h"

#include <utility>
#include <vector>

namespace encased_column {

/// Makes the neighbour list of the linear law's pairs in place of the host, whose one grid serves
/// grains of 15 to 1 badly: the same pairs, in the host's own list and contact history.
///
/// The host builds no list that is asked for as occasional; this object asks so for the pair
/// style's and fills it before the first force after each of the host's builds.
class PairList {
 public:
  explicit PairList(LAMMPS_NS::LAMMPS* lmp) : lmp_(lmp) {}

  /// At the start of a run, after `pair` asked for its lists. Where something else lives on the
  /// host's own build or its bins (meshes of the host, exclusions), nothing changes. Saves what
  /// contacts remember; throws InputError for a `neighbor` style that finds no contacts.
  void take_over(LAMMPS_NS::PairGran* pair);

  /// Before forces: makes the list if it is not there yet. True where it is a new one.
  bool update(LAMMPS_NS::PairGran* pair)
  {
    if (built() == built_) return false;
    if (taken_over_) build(pair);
    built_ = built();
    return true;
  }

 private:
  using Build = std::pair<LAMMPS_NS::bigint, LAMMPS_NS::bigint>;

  /// Number and step of the host's last build.
  Build built() const { return {lmp_->neighbor->ncalls, lmp_->neighbor->lastcall}; }
  bool host_list_is_needed() const;
  void build(LAMMPS_NS::PairGran* pair);

  LAMMPS_NS::LAMMPS* lmp_;
  bool taken_over_ = false;
  Build built_{-1, -1};
  GrainGrid grid_;
};

/// The pairs of the host's list, one after the other: the list itself is a row a grain, most of
/// them so short that the processor mispredicts the end of each loop.
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
