// SPDX-License-Identifier: GPL-2.0-only
#include "contact/pair_list.h"

#include "contact/grain_grid.h"
#include "core/input_error.h"

#include "neigh_request.h"
#include "pair_gran.h"
#include "timer.h"

#include <malloc.h>
#include <algorithm>
#include <string>

namespace encased_column {

namespace {

// The host's numbers of its styles of `neighbor`.
constexpr int bin = 1, multi = 2;

}  // namespace

void PairList::take_over(LAMMPS_NS::PairGran* pair)
{
  LAMMPS_NS::Neighbor* neighbor = lmp_->neighbor;
  if (neighbor->style == multi)
    throw InputError(
        "'neighbor' must take the style 'bin', found 'multi', with which the host finds no "
        "contacts, write for example 'neighbor 0.0005 bin'");
  // The host drops its lists, and with them the springs of the last run, where this run asks for
  // others.
  if (pair->computeflag()) pair->get_fix_history()->pre_exchange();
  built_ = none;
  taken_over_ = !host_list_is_needed(lmp_);
  if (!taken_over_) return;
  for (int n = 0; n < neighbor->nrequest; ++n)
    if (neighbor->requests[n]->requestor == pair) neighbor->requests[n]->occasional = 1;
}

// Walls of the host find grains in its bins, which are filled when it has a list to build.
bool PairList::host_list_is_needed(LAMMPS_NS::LAMMPS* lmp)
{
  if (lmp->neighbor->style != bin || lmp->neighbor->includegroup ||
      std::string(lmp->force->pair_style) != "gran")
    return true;
  for (int n = 0; n < lmp->modify->nfix; ++n)
    if (std::string(lmp->modify->fix[n]->style) == "neighlist/mesh") return true;
  return false;
}

void PairList::give_back_memory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

void PairList::build(LAMMPS_NS::NeighList& list, ListedPairs& pairs, const GrainReach& reach)
{
  const LAMMPS_NS::Atom* atom = lmp_->atom;
  LAMMPS_NS::Neighbor* const neighbor = lmp_->neighbor;
  LAMMPS_NS::NeighList& touches = *list.listgranhistory;
  if (list.get_maxlocal() < atom->nmax) list.grow(atom->nmax);
  if (touches.get_maxlocal() < atom->nmax) touches.grow(atom->nmax);
  // Known only now: the host reads its exclusions after the set-up of the pair styles.
  if (neighbor->exclude_setting()) {
    neighbor->build_one(list.index);
    read(list, pairs);
    return;
  }
  const int owned = atom->nlocal, all = owned + atom->nghost;
  // Spheres wider by their reach touch where two grains may. Not kept beside the list, as it is as
  // large.
  std::vector<double> wide(all);
  for (int i = 0; i < all; ++i)
    wide[i] = neighbor->contactDistanceFactor * atom->radius[i] + reach[i];
  GrainGrid grid;
  grid.sort(all ? atom->x[0] : nullptr, wide.data(), all);
  for (int i = 0; i < owned; ++i) {
    const int begin = pairs.size();
    grid.near(as_vec3(atom->x[i]), wide[i], i + 1, [&](int j) { pairs.add(i, j); });
    list.ilist[i] = i;
    list.numneigh[i] = pairs.size() - begin;
  }
  give_rows(list, pairs);
  list.inum = owned;
  list.gnum = 0;
  lmp_->timer->stamp(TIME_NEIGHBOR);
}

// What a grain may touch that has got fast: it and others may be anywhere in their reaches now, and
// on the other side later. No grid is there, nor needed for the few.
void PairList::add_wider(LAMMPS_NS::NeighList& list, PairHistory& history, const GrainReach& reach)
{
  const LAMMPS_NS::Atom* atom = lmp_->atom;
  const double factor = lmp_->neighbor->contactDistanceFactor;
  std::vector<std::pair<int, int>> more;
  for (const int i : reach.wider()) {
    const int others = atom->nlocal + (i < atom->nlocal ? atom->nghost : 0);
    for (int j = 0; j < others; ++j) {
      const double near =
          factor * (atom->radius[i] + atom->radius[j]) + 2.0 * (reach[i] + reach[j]);
      if (j != i && (as_vec3(atom->x[i]) - as_vec3(atom->x[j])).squaredNorm() <= near * near)
        more.push_back(std::minmax(i, j));
    }
  }
  history.take_back();
  history.pairs.insert(more);
  for (const auto& pair : more) list.numneigh[pair.first] = history.pairs.in_row_of(pair.first);
  give_rows(list, history.pairs);
}

/// The host's rows, of known lengths, are ours.
void PairList::give_rows(LAMMPS_NS::NeighList& list, ListedPairs& pairs)
{
  const int owned = lmp_->atom->nlocal;
  int begin = 0;
  for (int i = 0; i < owned; ++i) {
    list.firstneigh[i] = pairs.second() + begin;
    begin += list.numneigh[i];
    if (list.numneigh[i] > list.oneatom)
      lmp_->error->one(FLERR, ("a grain has more than " + std::to_string(list.oneatom) +
                               " neighbours, write 'neigh_modify one' with a larger number and "
                               "'page' with 10 times that")
                                  .c_str());
  }
}

void PairList::read(const LAMMPS_NS::NeighList& list, ListedPairs& pairs)
{
  for (int n = 0; n < list.inum; ++n) {
    const int i = list.ilist[n];
    for (int k = 0; k < list.numneigh[i]; ++k) pairs.add(i, list.firstneigh[i][k] & NEIGHMASK);
  }
}

}  // namespace encased_column
