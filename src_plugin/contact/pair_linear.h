#pragma once

#include "contact/model_linear.h"

#include "neigh_list.h"

namespace encased_column {

/// The linear law's own loop over pairs. The host's loop fills two records of some sixty numbers
/// for every listed pair, touching or not; this one looks at the distance first. Where something is
/// wanted that only the host's loop offers (virial, contact lists), that one runs, with the same
/// law.
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
        desk_(lmp)
  {
  }

  void init_granular() override
  {
    HostLoop::init_granular();
    desk_.open(rolling != LIGGGHTS::ContactModels::ROLLING_OFF);
    memory_ = this->get_history_offset("contact_memory");
  }

  void compute_force(PairGran* pair, int eflag, int vflag, int addflag) override
  {
    if (wants_host_loop(pair, eflag, vflag)) {
      HostLoop::compute_force(pair, eflag, vflag, addflag);
      return;
    }
    pair->evflag = pair->vflag_fdotr = 0;
    desk_.ask_probes();
    const bool advance = pair->computeflag() && pair->shearupdate();
    const LAMMPS_NS::NeighList& list = *pair->list;
    for (int n = 0; n < list.inum; ++n) press_neighbors_of(pair, list.ilist[n], advance);
  }

 private:
  static bool wants_host_loop(PairGran* pair, int eflag, int vflag)
  {
    return eflag || vflag || pair->cpl() || pair->storeContactForces() ||
           pair->storeContactForcesStress() || pair->storeSumDelta() ||
           pair->store_sum_normal_force() || pair->fr_pair() || pair->freeze_group_bit() ||
           !pair->computeflag();
  }

  void press_neighbors_of(PairGran* pair, int i, bool advance)
  {
    LAMMPS_NS::Atom* atom = lmp_->atom;
    const LAMMPS_NS::NeighList& list = *pair->list;
    const int* neighbors = list.firstneigh[i];
    int* flags = pair->listgranhistory->firstneigh[i];
    double* memories = pair->listgranhistory->firstdouble[i] + memory_;
    const int stride = pair->dnum();
    const int nlocal = atom->nlocal;
    const double dt = lmp_->update->dt;
    const double step = static_cast<double>(lmp_->update->ntimestep);
    const Vec3 x_i = as_vec3(atom->x[i]);
    const ContactBody body_i{atom->radius[i], as_vec3(atom->v[i]), as_vec3(atom->omega[i])};
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();

    for (int n = 0; n < list.numneigh[i]; ++n) {
      const int j = neighbors[n] & NEIGHMASK;
      const Vec3 apart = as_vec3(atom->x[j]) - x_i;
      const double reach = body_i.radius + atom->radius[j];
      const double square = apart.squaredNorm();
      if (square >= reach * reach) {
        flags[n] = 0;
        continue;
      }
      flags[n] = touching;
      const double distance = std::sqrt(square);
      const double mass =
          desk_.has_dashpots() ? effective_mass(atom->rmass[i], atom->rmass[j]) : 0.0;
      const Touch touch{reach - distance,
                        apart / distance,
                        mass,
                        body_i,
                        {atom->radius[j], as_vec3(atom->v[j]), as_vec3(atom->omega[j])}};
      const ContactAction action = resolve_contact<rolling != LIGGGHTS::ContactModels::ROLLING_OFF>(
          desk_.material(atom->type[i], atom->type[j]), touch, dt, step, advance,
          memories + n * stride);
      force += action.force;
      moment += action.moment_i;
      if (j < nlocal) {
        as_vec3(atom->f[j]) -= action.force;
        as_vec3(atom->torque[j]) += action.moment_j;
      }
      desk_.book(i, j, j < nlocal ? 1.0 : 0.5, advance, touch, action);
    }
    as_vec3(atom->f[i]) += force;
    as_vec3(atom->torque[i]) += moment;
  }

  static constexpr int touching = LIGGGHTS::ContactModels::CONTACT_NORMAL_MODEL |
                                  LIGGGHTS::ContactModels::CONTACT_TANGENTIAL_MODEL;
  LAMMPS_NS::LAMMPS* lmp_;
  ContactDesk desk_;
  int memory_ = 0;
};

}  // namespace encased_column
