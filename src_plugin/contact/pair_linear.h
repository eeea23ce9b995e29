// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/model_linear.h"
#include "contact/pair_list.h"
#include "contact/pair_loop.h"
#include "contact/touching_pairs.h"
#include "core/input_error.h"
#include "host/grains_and_box.h"

#include "compute.h"

namespace encased_column {

/// The linear law's own loop over pairs, and its own list of them. The host's loop fills two
/// records of some sixty numbers for every listed pair, touching or not; this one looks at the
/// distance first. Where something is wanted that only the host's loop offers (virial, contact
/// lists), or the deck asks for it, that one runs, with the same law.
template <int rolling>
class PairLinear
    : public LIGGGHTS::PairStyles::Granular<
          LIGGGHTS::ContactModels::ContactModel<LIGGGHTS::ContactModels::LinearStyle<rolling>>> {
  using HostLoop = LIGGGHTS::PairStyles::Granular<
      LIGGGHTS::ContactModels::ContactModel<LIGGGHTS::ContactModels::LinearStyle<rolling>>>;
  using PairGran = LAMMPS_NS::PairGran;
  static constexpr bool with_rolling = rolling != LIGGGHTS::ContactModels::ROLLING_OFF;

 public:
  PairLinear(LAMMPS_NS::LAMMPS* lmp, PairGran* parent, int64_t hash)
      : HostLoop(lmp, parent, hash),
        lmp_(lmp),
        parent_(parent),
        context_(lmp),
        list_(lmp)
  {
  }

  void settings(int narg, char** arg, LIGGGHTS::IContactHistorySetup* setup) override
  {
    try {
      std::vector<char*> rest(arg, arg + narg);
      loop_ = take_pair_loop(rest);
      HostLoop::settings(static_cast<int>(rest.size()), rest.data(), setup);
    } catch (const InputError& problem) {
      lmp_->error->all(FLERR, problem.what());
    }
  }

  void init_granular() override
  {
    HostLoop::init_granular();
    context_.open(with_rolling);
    memory_ = this->get_history_offset("contact_memory");
    history_ = static_cast<PairHistory*>(parent_->get_fix_history());
    rows_are_read_ = host_rows_are_read();
    try {
      list_.take_over(parent_);
    } catch (const InputError& problem) {
      lmp_->error->all(FLERR, problem.what());
    }
  }

  void compute_force(PairGran* pair, int eflag, int vflag, int addflag) override
  {
    list_.update(*pair->list, *history_, memory_ + 3, context_.reach());
    const bool advance = pair->computeflag() && pair->shearupdate();
    if (loop_ == PairLoop::host || wants_host_loop(pair, eflag, vflag)) {
      history_->lend(*pair->list);
      HostLoop::compute_force(pair, eflag, vflag, addflag);
    } else {
      history_->take_back();
      pair->evflag = pair->vflag_fdotr = 0;
      if (lmp_->atom->nlocal) press(advance);
    }
    if (advance) history_->pairs.set_step(static_cast<double>(lmp_->update->ntimestep));
  }

 private:
  /// Styles of the host that look at its rows of contacts themselves: its loop keeps them.
  bool host_rows_are_read() const
  {
    const auto begins = [](const char* style, const std::string& name) {
      return std::string(style).compare(0, name.size(), name) == 0;
    };
    const LAMMPS_NS::Modify* modify = lmp_->modify;
    for (int n = 0; n < modify->nfix; ++n)
      for (const char* name : {"heat/gran", "multicontact/"})
        if (begins(modify->fix[n]->style, name)) return true;
    for (int n = 0; n < modify->ncompute; ++n)
      if (begins(modify->compute[n]->style, "contact/atom/gran")) return true;
    return false;
  }

  bool wants_host_loop(PairGran* pair, int eflag, int vflag) const
  {
    return rows_are_read_ || eflag || vflag || pair->cpl() || pair->storeContactForces() ||
           pair->storeContactForcesStress() || pair->storeSumDelta() ||
           pair->store_sum_normal_force() || pair->fr_pair() || pair->freeze_group_bit() ||
           !pair->computeflag();
  }

  void press(bool advance)
  {
    context_.ask_observers();
    const GrainArrays grains(lmp_->atom);
    if (loop_ == PairLoop::batches)
      press_in_batches(grains, advance);
    else
      press_one_by_one(grains, advance);
  }

  /// Calls `found(i, j, memory)` for all pairs that touch.
  template <typename Found>
  void find_contacts(GrainArrays grains, const Found& found)
  {
    ListedPairs& pairs = history_->pairs;
    int touching[longest_block];
    for (int begin = 0; begin < pairs.size(); begin += longest_block) {
      fetch(grains, begin + fetched_ahead);
      const int* const first = pairs.first() + begin;
      const int* const second = pairs.second() + begin;
      const int number =
          find_touching_pairs(grains.x, grains.radius, first, second,
                              std::min(longest_block, pairs.size() - begin), touching);
      for (int m = 0; m < number; ++m)
        found(first[touching[m]], second[touching[m]], pairs.memory(begin + touching[m]) + memory_);
    }
  }

  /// Asks for what the law needs of the second grains of a block of pairs, which lie anywhere,
  /// while earlier blocks are worked on. Inline: as it returns nothing, a call would be left out.
  [[gnu::always_inline]] void fetch(GrainArrays grains, int begin) const
  {
    const ListedPairs& pairs = history_->pairs;
    const int end = std::min(begin + longest_block, pairs.size());
    for (int n = begin; n < end; ++n) {
      const int j = pairs.second()[n];
      __builtin_prefetch(grains.radius + j);
      __builtin_prefetch(grains.x + 3 * j);
      __builtin_prefetch(grains.v + 3 * j);
      __builtin_prefetch(grains.omega + 3 * j);
      __builtin_prefetch(grains.force + 3 * j, 1);
      __builtin_prefetch(grains.moment + 3 * j, 1);
    }
  }

  static ContactBody body(GrainArrays grains, int i)
  {
    return {grains.radius[i], as_vec3(grains.v + 3 * i), as_vec3(grains.omega + 3 * i)};
  }

  double mass_of(GrainArrays grains, int i, int j) const
  {
    return context_.has_dashpots() ? effective_mass(grains.mass[i], grains.mass[j]) : 0.0;
  }

  /// A pair across a border of ranks is found on both of them.
  static double share_of(GrainArrays grains, int j) { return j < grains.owned ? 1.0 : 0.5; }

  static void push(GrainArrays grains, int i, int j, const Vec3& force, const Vec3& moment_i,
                   const Vec3& moment_j)
  {
    as_vec3(grains.force + 3 * i) += force;
    as_vec3(grains.moment + 3 * i) += moment_i;
    if (j >= grains.owned) return;
    as_vec3(grains.force + 3 * j) -= force;
    as_vec3(grains.moment + 3 * j) += moment_j;
  }

  void press_in_batches(GrainArrays grains, bool advance)
  {
    find_contacts(grains, [&](int i, int j, double* memory) {
      batch_.add(i, j, share_of(grains, j), context_.material(grains.type[i], grains.type[j]),
                 as_vec3(grains.x + 3 * j) - as_vec3(grains.x + 3 * i), body(grains, i),
                 body(grains, j), mass_of(grains, i, j), memory);
      if (batch_.is_full()) press_batch(grains, advance);
    });
    press_batch(grains, advance);
  }

  void press_batch(GrainArrays grains, bool advance)
  {
    context_.resolve(batch_, advance);
    for (int n = 0; n < batch_.count(); ++n)
      push(grains, batch_.i(n), batch_.j(n), batch_.force(n), batch_.moment_i(n),
           batch_.moment_j(n));
    batch_.clear();
  }

  void press_one_by_one(GrainArrays grains, bool advance)
  {
    const double dt = lmp_->update->dt;
    const double step = static_cast<double>(lmp_->update->ntimestep);
    find_contacts(grains, [&](int i, int j, double* memory) {
      const ContactBody body_i = body(grains, i), body_j = body(grains, j);
      const Vec3 apart = as_vec3(grains.x + 3 * j) - as_vec3(grains.x + 3 * i);
      const double distance = apart.norm();
      const Touch touch{body_i.radius + body_j.radius - distance, apart / distance,
                        mass_of(grains, i, j), body_i, body_j};
      const ContactAction action = resolve_contact<with_rolling>(
          context_.material(grains.type[i], grains.type[j]), touch, dt, step, advance, memory);
      push(grains, i, j, action.force, action.moment_i, action.moment_j);
      context_.book(i, j, share_of(grains, j), advance, touch, action);
    });
  }

  static constexpr int fetched_ahead = 8 * longest_block;  ///< pairs
  LAMMPS_NS::LAMMPS* lmp_;
  PairGran* parent_;
  ContactContext context_;
  std::conditional_t<with_rolling, RollingBatch, ContactBatch> batch_;
  PairList list_;
  PairHistory* history_ = nullptr;
  bool rows_are_read_ = false;
  PairLoop loop_ = PairLoop::batches;
  int memory_ = 0;
};

}  // namespace encased_column
