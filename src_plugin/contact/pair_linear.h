// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/model_linear.h"
#include "contact/pair_list.h"
#include "contact/pair_loop.h"
#include "contact/touching_pairs.h"
#include "core/input_error.h"
#include "host/grains_and_box.h"

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
    try {
      list_.take_over(parent_);
    } catch (const InputError& problem) {
      lmp_->error->all(FLERR, problem.what());
    }
  }

  void compute_force(PairGran* pair, int eflag, int vflag, int addflag) override
  {
    if (list_.update(pair)) pairs_are_old_ = true;
    if (loop_ == PairLoop::host || wants_host_loop(pair, eflag, vflag)) {
      HostLoop::compute_force(pair, eflag, vflag, addflag);
      return;
    }
    if (pairs_are_old_) pairs_.take(*pair->list, pair->dnum());
    pairs_are_old_ = false;
    pair->evflag = pair->vflag_fdotr = 0;
    if (lmp_->atom->nlocal == 0) return;
    context_.ask_observers();
    const GrainArrays grains(lmp_->atom);
    const bool advance = pair->computeflag() && pair->shearupdate();
    if (loop_ == PairLoop::batches)
      press_in_batches(grains, advance);
    else
      press_one_by_one(grains, advance);
  }

 private:
  static bool wants_host_loop(PairGran* pair, int eflag, int vflag)
  {
    return eflag || vflag || pair->cpl() || pair->storeContactForces() ||
           pair->storeContactForcesStress() || pair->storeSumDelta() ||
           pair->store_sum_normal_force() || pair->fr_pair() || pair->freeze_group_bit() ||
           !pair->computeflag();
  }

  /// Calls `found(i, j, memory)` for all pairs that touch.
  template <typename Found>
  void find_contacts(GrainArrays grains, const Found& found)
  {
    const int stride = parent_->dnum();
    int touching[longest_block];
    for (const ListedPairs::Page& page : pairs_.pages())
      for (int begin = page.begin; begin < page.end; begin += longest_block) {
        const int* const first = pairs_.first() + begin;
        const int* const second = pairs_.second() + begin;
        const int number = find_touching_pairs(
            grains.x, grains.radius, first, second, std::min(longest_block, page.end - begin),
            touching_flag, page.flags + (begin - page.begin), touching);
        double* const memories = page.memories + (begin - page.begin) * stride + memory_;
        for (int m = 0; m < number; ++m)
          found(first[touching[m]], second[touching[m]], memories + touching[m] * stride);
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

  static constexpr int touching_flag = LIGGGHTS::ContactModels::CONTACT_NORMAL_MODEL |
                                       LIGGGHTS::ContactModels::CONTACT_TANGENTIAL_MODEL;
  LAMMPS_NS::LAMMPS* lmp_;
  PairGran* parent_;
  ContactContext context_;
  std::conditional_t<with_rolling, RollingBatch, ContactBatch> batch_;
  PairList list_;
  ListedPairs pairs_;
  bool pairs_are_old_ = true;
  PairLoop loop_ = PairLoop::batches;
  int memory_ = 0;
};

}  // namespace encased_column
