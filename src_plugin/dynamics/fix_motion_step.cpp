// What the motion does in a step, and how it finds inertia, step and equilibrium.
#include "dynamics/fix_motion.h"

#include "core/constants.h"
#include "dynamics/free_speed.h"
#include "dynamics/kinetic_energy.h"
#include "host/rank_sums.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

MovingGrains FixMotion::moving_grains() const
{
  if (atom->nlocal == 0) return {};
  return {atom->v[0], atom->omega[0], atom->radius, atom->rmass, atom->nlocal};
}

void FixMotion::set_masses()
{
  const MassScaling::Found found = mass_scaling.set_masses();
  loss_ += mass_scaling.take_loss();
  largest_factor_ = max_over_ranks(found.largest_factor, world);
  stable_step_ = min_over_ranks(found.stable_step, world);
}

// Of a fix that makes them at the end of a step, or in the set-up, where the host tells of all
// grains once more.
void FixMotion::admit_new_grains()
{
  mass_scaling.begin_step(moving_grains(), false);
  mass_scaling.admit_new_grains();
}

void FixMotion::set_step()
{
  if (mass_scaling.rule.scales() || atom->natoms == 0) return;
  update->update_time();  // with the step that was made
  update->dt = stable_step_;
}

void FixMotion::compute_unbalanced_ratio()
{
  ForceSums sums{0.0, 0.0, contact_force_sum_, contact_count_};
  double largest = 0.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double unbalanced = as_vec3(atom->f[i]).norm();
    sums.unbalanced += unbalanced;
    sums.grains += 1.0;
    largest = std::max(largest, unbalanced);
  }
  sum_over_ranks(&sums.unbalanced, sizeof(ForceSums) / sizeof(double), world);
  if (!std::isfinite(sums.unbalanced + sums.contact))
    error->fix_error(
        FLERR, this,
        ("the forces on the grains are not numbers at step " + std::to_string(update->ntimestep) +
         ", go back to the last restart file with a smaller step")
            .c_str());
  equilibrium_ = encased_column::compute_unbalanced_ratio(sums, max_over_ranks(largest, world));
}

GrainRow FixMotion::row(int first, int count) const
{
  return {atom->v[first],
          atom->omega[first],
          atom->f[first],
          atom->torque[first],
          atom->radius + first,
          mass_scaling.inertial_masses() + first,
          count};
}

/// Calls `kick(first, count)` for all grains of the group, in rows.
template <typename Kick>
void FixMotion::for_rows(const Kick& kick) const
{
  const int* const mask = atom->mask;
  for (int first = 0; first < atom->nlocal;) {
    const int last = std::min(first + longest_row, atom->nlocal);
    int end = igroup == 0 ? last : first;
    while (end < last && (mask[end] & groupbit)) ++end;
    if (end > first) kick(first, end - first);
    first = end > first ? end : first + 1;
  }
}

void FixMotion::slow_down(int first, int count)
{
  double* const v = atom->v[first];
  for (int k = 0; k < count; ++k) {
    const int i = first + k;
    if (as_vec3(v + 3 * k).squaredNorm() <= free_speed_square_ ||
        !feels_only_weight(as_vec3(atom->f[i]), atom->rmass[i], gravity_))
      continue;
    loss_ += slow_down_to(free_speed_square_, inertial_mass(i), v + 3 * k);
  }
}

void FixMotion::finish_step()
{
  if (!unfinished_) return;
  unfinished_ = false;
  for_rows([&](int first, int count) {
    loss_ += kick_grains(row(first, count), damping_, 0.5 * update->dt).loss;
  });
  mass_scaling.settle();
  loss_ += mass_scaling.take_loss();
}

void FixMotion::initial_integrate(int)
{
  if (anew_) {
    finish_step();  // with the masses and the step it was made with
    look_anew();
  }
  anew_ = setting_up_ = false;
  if (made_grains_) admit_new_grains();
  if (unfinished_) mass_scaling.sort_raised();
  const double dt = update->dt;
  for_rows([&](int first, int count) {
    const GrainRow grains = row(first, count);
    RowKick kick;
    if (unfinished_ && !mass_scaling.raised_before(first + count)) {
      const TwoKicks kicks = kick_grains_twice(grains, damping_, 0.5 * dt);
      loss_ += kicks.loss_of_last;
      kick = kicks.first;
    } else {
      if (unfinished_) {
        loss_ += kick_grains(grains, damping_, 0.5 * dt).loss;
        mass_scaling.settle(first + count);
      }
      kick = kick_grains(grains, damping_, 0.5 * dt);
    }
    loss_ += kick.loss;
    if (3.0 * kick.fastest > free_speed_square_) slow_down(first, count);
    double* const __restrict x = atom->x[first];
    const double* const __restrict v = atom->v[first];
    for (int k = 0; k < 3 * count; ++k) x[k] += dt * v[k];
    if (starts_sums_) start_sums(first, count);
  });
  mass_scaling.settle();
  loss_ += mass_scaling.take_loss();
  unfinished_ = false;
  sums_started_ = starts_sums_;
}

// Where nobody looks at velocities before the next step, its first half kick comes in the same pass
// over the grains as the last one of this step: the pass takes its time to fetch them.
void FixMotion::final_integrate()
{
  unfinished_ = true;
  const bool weighs = wants_contacts(update->ntimestep);
  if (!weighs && !is_looked_at()) return;
  if (weighs) set_masses();
  finish_step();
  if (!weighs) return;
  weighs_new_grains_ = false;
  compute_unbalanced_ratio();
  set_step();
}

}  // namespace encased_column
