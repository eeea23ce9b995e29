// One row of `fix specimen/history`: its columns, and where each number comes from.
#include "measure/fix_specimen_history.h"

#include "dynamics/fix_motion.h"
#include "dynamics/inertial_number.h"
#include "measure/coordination.h"
#include "measure/sphere_overlap.h"
#include "servo/fix_servo_platen.h"

namespace encased_column {

// One list for header and order of the columns.
const std::vector<std::string>& FixSpecimenHistory::columns()
{
  static const std::vector<std::string> names{"step [-]",
                                              "axial_strain [-]",
                                              "stress_top [Pa]",
                                              "stress_bottom [Pa]",
                                              "confining_stress [Pa]",
                                              "deviatoric_stress_top [Pa]",
                                              "deviatoric_stress_bottom [Pa]",
                                              "mean_stress [Pa]",
                                              "volumetric_strain [-]",
                                              "height [m]",
                                              "radius [m]",
                                              "porosity [-]",
                                              "porosity_less_overlap [-]",
                                              "coordination_number [-]",
                                              "coordination_number_bearing [-]",
                                              "radial_strain_25 [-]",
                                              "radial_strain_50 [-]",
                                              "radial_strain_75 [-]",
                                              "unbalanced_average [-]",
                                              "unbalanced_maximum [-]",
                                              "inertial_number [-]",
                                              "work_platens [J]",
                                              "work_side [J]",
                                              "work_gravity [J]",
                                              "energy_elastic [J]",
                                              "energy_kinetic [J]",
                                              "loss_friction [J]",
                                              "loss_rolling [J]",
                                              "loss_dashpots [J]",
                                              "loss_damping [J]",
                                              "energy_error [-]",
                                              "core_axial_stress [Pa]",
                                              "core_radial_stress [Pa]"};
  return names;
}

SpecimenState FixSpecimenHistory::state() const
{
  SpecimenState s;
  const double z_low = bottom_->height(), z_high = top_->height();
  s.height = z_high - z_low;
  s.volume = side_->enclosed_volume(z_low, z_high);
  for (int n = 0; n < 3; ++n) s.radius[n] = side_->radius_at(z_low + 0.25 * (n + 1) * s.height);
  s.stress_top = top_->stress();
  s.stress_bottom = bottom_->stress();
  s.confining_stress = side_->confining_stress();
  return s;
}

void FixSpecimenHistory::take_sample()
{
  const Sums sums = sum_up();
  check_grains(sums);
  now_ = state();
  energy_ = {top_->work_on_grains() + bottom_->work_on_grains(),
             side_->work(),
             sums.weight_height,
             sums.elastic + side_->stored_energy(),
             sums.kinetic + side_->kinetic_energy(),
             sums.friction,
             sums.rolling,
             sums.dashpots,
             motion_->damping_loss() + side_->damping_loss()};
  if (reference_wanted_) take_reference();

  const double confining = now_.confining_stress;
  const double p = mean_stress(0.5 * (now_.stress_top + now_.stress_bottom), confining);
  const double rate = (top_->speed() + bottom_->speed()) / now_.height;
  // Stress of the grains, spread over the room they take up with their share of the voids.
  const double per_volume =
      sums.core_solid > 0.0 ? sums.solid / now_.volume / sums.core_solid : 0.0;
  const ContactCount count{sums.grains, sums.ends, sums.without_contact, sums.with_one_contact};
  const EnergyAccount& start = balance_.at_start();
  const UnbalancedForceRatio& equilibrium = motion_->unbalanced_ratio();
  row_ = {static_cast<double>(update->ntimestep),
          shortening(reference_.height, now_.height),
          now_.stress_top,
          now_.stress_bottom,
          confining,
          deviatoric_stress(now_.stress_top, confining),
          deviatoric_stress(now_.stress_bottom, confining),
          p,
          shortening(reference_.volume, now_.volume),
          now_.height,
          now_.radius[1],
          porosity(sums.solid, now_.volume),
          porosity(sums.solid - sums.shared, now_.volume),
          coordination_number(count),
          bearing_coordination_number(count),
          shortening(reference_.radius[0], now_.radius[0]),
          shortening(reference_.radius[1], now_.radius[1]),
          shortening(reference_.radius[2], now_.radius[2]),
          equilibrium.average,
          equilibrium.maximum,
          p > 0.0 ? inertial_number(rate, sums.diameter / sums.mass, sums.inertia / sums.solid, p)
                  : 0.0,
          energy_.work_platens - start.work_platens,
          energy_.work_side - start.work_side,
          energy_.work_gravity - start.work_gravity,
          energy_.elastic,
          energy_.kinetic,
          energy_.friction - start.friction,
          energy_.rolling - start.rolling,
          energy_.dashpots - start.dashpots,
          energy_.damping - start.damping,
          balance_.error(energy_),
          sums.core_axial * per_volume,
          sums.core_radial * per_volume};
}

void FixSpecimenHistory::take_reference()
{
  reference_ = now_;
  balance_.start(energy_);
  reference_wanted_ = false;
}

}  // namespace encased_column
