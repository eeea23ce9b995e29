// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/listed_pairs.h"
#include "host/host_types.h"

#include "fix_contact_history.h"
#include "neigh_list.h"

namespace encased_column {

/// The host's fix that keeps what contacts remember while there is no list of pairs: grains take it
/// along to other places and ranks and into restart files. While there is one the memories are here
/// in `pairs`, or lent to the host's own loop over pairs, which wants a row for every listed one.
/// With a pair style that is not ours it is the host's fix and nothing else.
class PairHistory : public LAMMPS_NS::FixContactHistory {
 public:
  using FixContactHistory::FixContactHistory;

  /// Changed by the pair style only after take_back().
  ListedPairs pairs;

  /// New pairs are in `pairs`, up to ListedPairs::end(): they get what the grains keep of them.
  void take();
  /// For the host's loop over its `list` of the same pairs, until take_back().
  void lend(LAMMPS_NS::NeighList& list);
  void take_back();

  void pre_exchange() override;
  void write_restart(FILE* file) override;
  double memory_usage() override;

 protected:
  void allocate_pages() override;

 private:
  void give_to_grains();
  void make_room(int i);

  bool in_charge_ = false, lent_ = false;
  int listed_ = 0;          ///< grains when the list was made
  std::vector<int> flags_;  ///< while lent, of each pair: it touches
  std::vector<double> lent_memories_;
};

}  // namespace encased_column
