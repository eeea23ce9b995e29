// What the motion does in a step, and how it finds inertia, step and equilibrium.
#include "dynamics/fix_motion.h"

#include "core/constants.h"
#include "dynamics/free_speed.h"
#include "dynamics/kinetic_energy.h"
#include "host/rank_sums.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

// A grain that touches little now may touch more in the next step: no grain counts as softer than
// one contact with something flat of its own kind makes it. Walls see to themselves.
void FixMotion::set_inertia()
{
  double stable = 1e300, factor = 1.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    const double one_contact = pi * atom->radius[i] * stiffest_material_;
    // Grains that were made since the contacts were collected have none.
    const bool known = i < static_cast<int>(stiffness_.size());
    const double stiffness = std::max(one_contact, known ? stiffness_[i].decisive(rolling_) : 0.0);
    inertia_[i] = atom->rmass[i];
    if (scaled_step_ > 0.0)
      inertia_[i] = std::max(inertia_[i], mass_for_step(scaled_step_, stiffness, safety_));
    factor = std::max(factor, inertia_[i] / atom->rmass[i]);
    stable = std::min(stable, stable_step(inertia_[i], stiffness, safety_));
  }
  largest_factor_ = max_over_ranks(factor, world);
  stable_step_ = min_over_ranks(stable, world);
  if (scaled_step_ > 0.0 || atom->natoms == 0) return;
  update->update_time();  // with the step that was made
  update->dt = stable_step_;
}

// With density scaling a new grain, still of its true mass, may be far too light for its contacts.
void FixMotion::bear_first_contacts()
{
  if (scaled_step_ <= 0.0) return;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (inertia_[i] != atom->rmass[i]) continue;
    const double needed = mass_for_step(scaled_step_, stiffness_[i].decisive(rolling_), safety_);
    if (needed > inertia_[i]) make_heavier(i, needed);
  }
  std::sort(heavier_.begin(), heavier_.end());
}

double FixMotion::kinetic_energy_of(int i) const
{
  return kinetic_energy(inertia_[i], atom->radius[i], as_vec3(atom->v[i]), as_vec3(atom->omega[i]));
}

// The way of this step was gone at the old speed: the grain slows down once the force of the step
// has done its work on it. What the higher mass makes of its energy until then is booked at once.
void FixMotion::make_heavier(int i, double inertia)
{
  heavier_.emplace_back(i, inertia_[i] / inertia);
  loss_ += kinetic_energy_of(i);
  inertia_[i] = inertia;
  loss_ -= kinetic_energy_of(i);
  if (setting_up_) keep_momentum();  // no way was gone
}

void FixMotion::keep_momentum(int end)
{
  for (; slowed_ < heavier_.size() && heavier_[slowed_].first < end; ++slowed_) {
    const auto& [i, part] = heavier_[slowed_];
    loss_ += kinetic_energy_of(i);
    as_vec3(atom->v[i]) *= part;
    as_vec3(atom->omega[i]) *= part;
    loss_ -= kinetic_energy_of(i);
  }
  if (slowed_ < heavier_.size()) return;
  heavier_.clear();
  slowed_ = 0;
}

void FixMotion::weigh_equilibrium()
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
  equilibrium_ = equilibrium_of(sums, max_over_ranks(largest, world));
}

GrainRow FixMotion::row(int first, int count) const
{
  return {atom->v[first],       atom->omega[first], atom->f[first], atom->torque[first],
          atom->radius + first, inertia_ + first,   count};
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
    loss_ += slow_down_to(free_speed_square_, inertia_[i], v + 3 * k);
  }
}

void FixMotion::finish_step()
{
  if (!unfinished_) return;
  unfinished_ = false;
  for_rows([&](int first, int count) {
    loss_ += kick_grains(row(first, count), damping_, 0.5 * update->dt).loss;
  });
  keep_momentum();
}

void FixMotion::initial_integrate(int)
{
  if (anew_) {
    finish_step();  // with the masses and the step it was made with
    look_anew();
  }
  anew_ = setting_up_ = false;
  if (unfinished_)
    std::sort(heavier_.begin(), heavier_.end());
  else
    keep_momentum();
  const double dt = update->dt;
  for_rows([&](int first, int count) {
    const GrainRow grains = row(first, count);
    RowKick kick;
    if (unfinished_ && !gets_heavier_before(first + count)) {
      const TwoKicks kicks = kick_grains_twice(grains, damping_, 0.5 * dt);
      loss_ += kicks.loss_of_last;
      kick = kicks.first;
    } else {
      if (unfinished_) {
        loss_ += kick_grains(grains, damping_, 0.5 * dt).loss;
        keep_momentum(first + count);
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
  keep_momentum();
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
  if (weighs_new_grains_) bear_first_contacts();
  finish_step();
  if (!weighs) return;
  weighs_new_grains_ = false;
  weigh_equilibrium();
  set_inertia();
}

}  // namespace encased_column
