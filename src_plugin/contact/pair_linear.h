#pragma once

#include "contact/model_linear.h"
#include "contact/pair_list.h"
#include "core/input_error.h"
#include "host/grain_arrays.h"

#include "neigh_list.h"

namespace encased_column {

/// The linear law's own loop over pairs, and its own list of them. The host's loop fills two
/// records of some sixty numbers for every listed pair, touching or not; this one looks at the
/// distance first. Where something is wanted that only the host's loop offers (virial, contact
/// lists), that one runs, with the same law.
template <int rolling>
class PairLinear
    : public LIGGGHTS::PairStyles::Granular<
          LIGGGHTS::ContactModels::ContactModel<LIGGGHTS::ContactModels::LinearStyle<rolling>>> {
  using HostLoop = LIGGGHTS::PairStyles::Granular<
      LIGGGHTS::ContactModels::ContactModel<LIGGGHTS::ContactModels::LinearStyle<rolling>>>;
  using PairGran = LAMMPS_NS::PairGran;

 public:
  PairLinear(LAMMPS_NS::LAMMPS* lmp, PairGran* parent, int64_t hash)
      : HostLoop(lmp, parent, hash),
        lmp_(lmp),
        parent_(parent),
        desk_(lmp),
        list_(lmp)
  {
  }

  void init_granular() override
  {
    HostLoop::init_granular();
    desk_.open(rolling != LIGGGHTS::ContactModels::ROLLING_OFF);
    memory_ = this->get_history_offset("contact_memory");
    try {
      list_.take_over(parent_);
    } catch (const InputError& problem) {
      lmp_->error->all(FLERR, problem.what());
    }
  }

  void compute_force(PairGran* pair, int eflag, int vflag, int addflag) override
  {
    list_.update(pair);
    if (wants_host_loop(pair, eflag, vflag)) {
      HostLoop::compute_force(pair, eflag, vflag, addflag);
      return;
    }
    pair->evflag = pair->vflag_fdotr = 0;
    if (lmp_->atom->nlocal == 0) return;
    desk_.ask_probes();
    const GrainArrays grains(lmp_->atom);
    const bool advance = pair->computeflag() && pair->shearupdate();
    const LAMMPS_NS::NeighList& list = *pair->list;
    for (int n = 0; n < list.inum; ++n) press_neighbors_of(grains, pair, list.ilist[n], advance);
  }

 private:
  static bool wants_host_loop(PairGran* pair, int eflag, int vflag)
  {
    return eflag || vflag || pair->cpl() || pair->storeContactForces() ||
           pair->storeContactForcesStress() || pair->storeSumDelta() ||
           pair->store_sum_normal_force() || pair->fr_pair() || pair->freeze_group_bit() ||
           !pair->computeflag();
  }

  void press_neighbors_of(const GrainArrays& grains, PairGran* pair, int i, bool advance)
  {
    const LAMMPS_NS::NeighList& list = *pair->list;
    const int count = list.numneigh[i];
    const int* __restrict neighbors = list.firstneigh[i];
    int* __restrict flags = pair->listgranhistory->firstneigh[i];
    double* __restrict memories = pair->listgranhistory->firstdouble[i] + memory_;
    const int stride = pair->dnum();
    const double dt = lmp_->update->dt;
    const double step = static_cast<double>(lmp_->update->ntimestep);
    const Vec3 x_i = as_vec3(grains.x + 3 * i);
    const ContactBody body_i{grains.radius[i], as_vec3(grains.v + 3 * i),
                             as_vec3(grains.omega + 3 * i)};
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();

    for (int n = 0; n < count; ++n) {
      const int j = neighbors[n] & NEIGHMASK;
      const Vec3 apart = as_vec3(grains.x + 3 * j) - x_i;
      const double reach = body_i.radius + grains.radius[j];
      const double square = apart.squaredNorm();
      if (square >= reach * reach) {
        flags[n] = 0;
        continue;
      }
      flags[n] = touching;
      const double distance = std::sqrt(square);
      const double mass =
          desk_.has_dashpots() ? effective_mass(grains.mass[i], grains.mass[j]) : 0.0;
      const Touch touch{
          reach - distance,
          apart / distance,
          mass,
          body_i,
          {grains.radius[j], as_vec3(grains.v + 3 * j), as_vec3(grains.omega + 3 * j)}};
      const ContactAction action = resolve_contact<rolling != LIGGGHTS::ContactModels::ROLLING_OFF>(
          desk_.material(grains.type[i], grains.type[j]), touch, dt, step, advance,
          memories + n * stride);
      force += action.force;
      moment += action.moment_i;
      const bool owned = j < grains.owned;
      if (owned) {
        as_vec3(grains.force + 3 * j) -= action.force;
        as_vec3(grains.moment + 3 * j) += action.moment_j;
      }
      desk_.book(i, j, owned ? 1.0 : 0.5, advance, touch, action);
    }
    as_vec3(grains.force + 3 * i) += force;
    as_vec3(grains.moment + 3 * i) += moment;
  }

  static constexpr int touching = LIGGGHTS::ContactModels::CONTACT_NORMAL_MODEL |
                                  LIGGGHTS::ContactModels::CONTACT_TANGENTIAL_MODEL;
  LAMMPS_NS::LAMMPS* lmp_;
  PairGran* parent_;
  ContactDesk desk_;
  PairList list_;
  int memory_ = 0;
};

}  // namespace encased_column
