// SPDX-License-Identifier: GPL-2.0-only
#include "contact/pair_list_timing.h"

#include "contact/pair_list.h"
#include "host/find_fix.h"
#include "host/ranks.h"
#include "host/reveal.h"
#include "host/velocity_watchers.h"

#include "neigh_request.h"
#include "output.h"

#include <algorithm>
#include <limits>

namespace encased_column {

// Output::restart_requested() takes in what a signal asks for, on one rank perhaps.
struct NextRestart {
  using type = LAMMPS_NS::bigint LAMMPS_NS::Output::*;
  friend type reveal(NextRestart);
};
template struct Reveal<NextRestart, &LAMMPS_NS::Output::next_restart>;

namespace {

constexpr int never = -1;

/// Where the host's last lists found the grains: it keeps that for its own check.
struct ListedPlaces : LAMMPS_NS::Neighbor {
  static const double* of(LAMMPS_NS::Neighbor* neighbor)
  {
    return (neighbor->*(&ListedPlaces::xhold))[0];
  }
};

/// By sizes of types it brings too few ghosts for wide reaches.
struct GhostsByType : LAMMPS_NS::Comm {
  static bool are_brought_by(LAMMPS_NS::Comm* comm)
  {
    constexpr int single = 0;  // the host's number of this style of `communicate`
    return comm->*(&GhostsByType::style) != single;
  }
};

/// True where the host's check is wanted, or what else it decides on: it looks by half a skin.
bool host_decides(LAMMPS_NS::LAMMPS* lmp, const LAMMPS_NS::Fix* motion)
{
  using namespace LAMMPS_NS::FixConst;
  constexpr int within_step = PRE_INITIAL_INTEGRATE | INITIAL_INTEGRATE | ITERATE_IMPLICITLY |
                              POST_INTEGRATE | PRE_NEIGHBOR | PRE_FORCE | PRE_FINAL_INTEGRATE |
                              FINAL_INTEGRATE;
  LAMMPS_NS::Neighbor& neighbor = *lmp->neighbor;
  for (int n = 0; n < neighbor.old_nrequest; ++n)  // those of this run, once lists are there
    if (!neighbor.old_requests[n]->pair) return true;
  return motion->igroup != 0 || !neighbor.dist_check || neighbor.build_once ||
         neighbor.exclude_setting() || lmp->domain->box_change || lmp->domain->triclinic ||
         !lmp->comm->ghost_velocity || GhostsByType::are_brought_by(lmp->comm) ||
         PairList::host_list_is_needed(lmp) || others_act(lmp, motion, within_step) ||
         fixes_that_are<PairListTimingOwner>(lmp).size() != 1;
}

/// True where a list is made in this step for another reason than a grain that left its reach.
bool is_forced(LAMMPS_NS::LAMMPS* lmp, const LAMMPS_NS::Fix* motion)
{
  const LAMMPS_NS::bigint step = lmp->update->ntimestep;
  if (lmp->output->*reveal(NextRestart()) == step) return true;
  for (int n = 0; n < lmp->modify->nfix; ++n) {
    const LAMMPS_NS::Fix* const fix = lmp->modify->fix[n];
    if (fix != motion && fix->force_reneighbor && fix->next_reneighbor == step) return true;
  }
  return false;
}

/// Along the axes that are cut [m].
double width_of_rank(LAMMPS_NS::LAMMPS* lmp)
{
  double width = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; ++a)
    if (lmp->comm->procgrid[a] > 1)
      width = std::min(width, lmp->domain->subhi[a] - lmp->domain->sublo[a]);
  return width;
}

/// Sets the borders behind which other ranks or images of this one are.
void set_borders(LAMMPS_NS::LAMMPS* lmp, ReachRule& rule)
{
  const LAMMPS_NS::Domain& domain = *lmp->domain;
  const LAMMPS_NS::Comm& comm = *lmp->comm;
  for (int a = 0; a < 3; ++a) {
    const bool periodic = domain.periodicity[a] != 0;
    if (periodic || comm.myloc[a] > 0) rule.low(a) = domain.sublo[a];
    if (periodic || comm.myloc[a] + 1 < comm.procgrid[a]) rule.high(a) = domain.subhi[a];
  }
  rule.beyond = std::max(0.5 * (comm.cutghost[0] - rule.range), 0.0);
}

ListedGrains grains_of(LAMMPS_NS::Atom* atom)
{
  const int all = atom->nlocal + atom->nghost;
  if (all == 0) return {};
  return {atom->x[0], atom->v[0], atom->radius, atom->nlocal, all};
}

/// So many skins farther than the host's own lists need them: as much wider are the reaches of
/// grains near a border. All that wide reaches could use would double the ghosts.
constexpr double ghosts_beyond = 4.0;

}  // namespace

double PairListTiming::ghost_cutoff(LAMMPS_NS::LAMMPS* lmp)
{
  const LAMMPS_NS::Neighbor& neighbor = *lmp->neighbor;
  return neighbor.cutneighmax - neighbor.skin + 2.0 * ghosts_beyond * neighbor.skin;
}

void PairListTiming::take_over(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix* motion)
{
  motion->next_reneighbor = never;
  ours_ = !host_decides(lmp, motion);
  if (ours_) lmp->neighbor->build_once = 1;
}

void PairListTiming::give_back(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix* motion)
{
  if (!ours_) return;
  ours_ = false;
  lmp->neighbor->build_once = 0;
  motion->next_reneighbor = lmp->update->ntimestep + 1;
}

void PairListTiming::start(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix* motion, bool at_set_up)
{
  if (!ours_) return;
  const LAMMPS_NS::Neighbor& neighbor = *lmp->neighbor;
  const ListedGrains grains = grains_of(lmp->atom);
  ReachRule rule{0.5 * neighbor.skin, neighbor.cutneighmax, neighbor.contactDistanceFactor};
  if (!at_set_up && !is_forced(lmp, motion))
    rule.horizon = reach_horizon(rule.least, sum_over_ranks(sum_of_speeds(grains), lmp->world) /
                                                 static_cast<double>(lmp->atom->natoms));
  rule.thinnest = min_over_ranks(width_of_rank(lmp), lmp->world);
  set_borders(lmp, rule);
  account_.start(grains, rule);
  lmp->comm->forward_comm_fix(motion);
  account_.forget_wider();
}

void PairListTiming::ask(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix* motion, double way)
{
  if (!ours_) return;
  using Answer = ReachAccount::Answer;
  Answer answer = Answer::lists_hold;
  if (account_.begin_step(way) && lmp->atom->nlocal > 0)
    answer = account_.look(grains_of(lmp->atom), ListedPlaces::of(lmp->neighbor));
  answer = static_cast<Answer>(max_over_ranks(static_cast<double>(answer), lmp->world));
  if (answer == Answer::lists_end) motion->next_reneighbor = lmp->update->ntimestep;
  if (answer != Answer::some_are_wider) return;
  account_.set_wider();
  lmp->comm->forward_comm_fix(motion);
}

}  // namespace encased_column
