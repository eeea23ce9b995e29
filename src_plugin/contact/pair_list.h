// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/grain_reach.h"
#include "contact/pair_history.h"

#include <utility>

namespace LAMMPS_NS {
class PairGran;
}

namespace encased_column {

/// Makes the neighbour list of the linear law's pairs in place of the host, whose one grid serves
/// grains of 15 to 1 badly: the pairs that may touch until a grain leaves its reach, which the
/// host's own list then points to.
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
  /// True where the host's own list of pairs, or its bins, are needed.
  static bool host_list_is_needed(LAMMPS_NS::LAMMPS* lmp);

  /// Before forces: makes the host's `list` if it is not there yet, by the `reach` of its grains,
  /// and adds to it where that got wider. The pairs of a new one go to `history`, whose contacts
  /// remember the step they were last seen at `place`.
  void update(LAMMPS_NS::NeighList& list, PairHistory& history, int place, const GrainReach& reach)
  {
    if (built() == built_) {
      if (reach.is_wider_here()) add_wider(list, history, reach);
      return;
    }
    const bool in_set_up = built_ == none;
    history.pairs.start(history.get_dnum(), place);
    if (in_set_up) give_back_memory();
    if (taken_over_)
      build(list, history.pairs, reach);
    else
      read(list, history.pairs);
    history.pairs.end();
    history.take();
    if (in_set_up) give_back_memory();
    built_ = built();
  }

 private:
  using Build = std::pair<LAMMPS_NS::bigint, LAMMPS_NS::bigint>;
  static constexpr Build none{-1, -1};

  /// Number and step of the host's last build.
  Build built() const { return {lmp_->neighbor->ncalls, lmp_->neighbor->lastcall}; }
  /// What was freed, to the machine: in set-ups, where most memory is in use. It is too slow for
  /// the lists between.
  static void give_back_memory();
  void build(LAMMPS_NS::NeighList& list, ListedPairs& pairs, const GrainReach& reach);
  void add_wider(LAMMPS_NS::NeighList& list, PairHistory& history, const GrainReach& reach);
  void give_rows(LAMMPS_NS::NeighList& list, ListedPairs& pairs);
  static void read(const LAMMPS_NS::NeighList& list, ListedPairs& pairs);

  LAMMPS_NS::LAMMPS* lmp_;
  bool taken_over_ = false;
  Build built_ = none;
};

}  // namespace encased_column
