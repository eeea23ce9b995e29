// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/contact_context.h"
#include "contact/contact_memory_fix.h"
#include "core/input_error.h"
#include "core/keyword_table.h"
#include "host/grains_and_box.h"
#include "servo/near_grains.h"
#include "servo/wall_motion.h"

#include <string>
#include <vector>

namespace encased_column {

/// What a rigid platen and a rigid cylinder share: contacts with the grains by the linear law, the
/// motion, the load, the work, and the state in restart files. The walls are exact surfaces, not
/// meshes: on facets a grain that rolls over an edge is pushed by two of them, then by one, and
/// never comes to rest.
class RigidWall : public ContactMemoryFix {
 public:
  RigidWall(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup(int) override;
  void initial_integrate(int) override;
  void final_integrate() override;
  int modify_param(int narg, char** arg) override;
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

  /// Of all ranks, to be asked on all of them together: summed up when first asked in a step.
  const WallLoad& load() const;
  double work_on_grains() const;           ///< of all ranks [J], to be asked on all of them
  double speed() const { return speed_; }  ///< towards the specimen [m/s]
  double ramp_left() const { return static_cast<double>(motion_.ramp_left(update->ntimestep)); }

 protected:
  void read_wall(const Options& options);
  /// Finds the fixes this wall refers to; throws InputError.
  virtual void find_partners() = 0;
  /// True where they are found and have not been taken away since.
  virtual bool has_partners() const = 0;
  virtual double loaded_area() const = 0;     ///< turns stress into force [m^2]
  virtual double mean_radius() const = 0;     ///< of the specimen at this wall [m]
  virtual void advance(double distance) = 0;  ///< towards the specimen [m]
  /// One number [m] that says where the wall is, for the restart file.
  virtual double position() const = 0;
  virtual void set_position(double position) = 0;
  virtual void press_grains() = 0;

  /// Contacts of all grains with `shape`; called by press_grains().
  template <typename Shape>
  void press_grains_with(const Shape& shape);

 private:
  template <typename Shape>
  void list_grains_near(const Shape& shape);
  template <typename Shape, typename Batch>
  void press_in_batches(const Shape& shape, const GrainArrays& grains, Batch& batch);
  template <typename Batch>
  void press_batch(const GrainArrays& grains, Batch& batch);
  double stress_now() const;
  void check_reach();

  bool is_set_up_ = false;
  double restored_stress_ = 0.0;  ///< [Pa]
  Options on_fix_line_;
  WallMotion motion_;
  ContactContext context_;
  ContactBatch batch_;
  RollingBatch rolling_batch_;
  int wall_type_ = 0;
  bool rolling_ = false;
  bool advance_memory_ = true;
  bool material_is_new_ = false;
  /// The masses may not allow for this contact yet, though it was there before this step.
  bool all_are_new_ = false;
  WallLoad own_load_;     ///< of this rank
  mutable WallLoad sum_;  ///< of all, once load() was asked for it
  mutable bool summed_ = true;
  double speed_ = 0.0;  ///< of this step [m/s]
  WallWork work_;       ///< of this rank
  NearGrains near_;
};

template <typename Shape>
void RigidWall::press_grains_with(const Shape& shape)
{
  context_.ask_observers();
  own_load_ = WallLoad();
  summed_ = false;
  // Radii grow in steps that make new lists.
  all_are_new_ = !advance_memory_ || neighbor->ago == 0 || material_is_new_;
  material_is_new_ = false;
  if (context_.needs_lists() || near_.is_stale(position(), neighbor->skin)) list_grains_near(shape);
  if (near_.numbers().empty()) return;
  const GrainArrays grains(atom);
  if (rolling_)
    press_in_batches(shape, grains, rolling_batch_);
  else
    press_in_batches(shape, grains, batch_);
}

template <typename Shape>
void RigidWall::list_grains_near(const Shape& shape)
{
  near_.list(shape, position(), context_.reach(), atom->nlocal ? atom->x[0] : nullptr, atom->radius,
             atom->nlocal, [this](int i) { return (atom->mask[i] & groupbit) != 0; });
  remember(near_.numbers());
}

template <typename Shape, typename Batch>
void RigidWall::press_in_batches(const Shape& shape, const GrainArrays& grains, Batch& batch)
{
  near_.find_touching(
      shape, grains.x, grains.radius, [&](int n, double overlap, const Vec3& normal) {
        const int i = near_.numbers()[n];
        const double radius = grains.radius[i];
        batch.add(i, -1, 1.0, context_.material(grains.type[i], wall_type_),
                  distance_to_wall(radius, overlap) * normal,
                  {radius, as_vec3(grains.v + 3 * i), as_vec3(grains.omega + 3 * i)},
                  {0.0, -speed_ * normal, Vec3::Zero()},
                  context_.has_dashpots() ? grains.mass[i] : 0.0, contact_memory(n));
        if (batch.is_full()) press_batch(grains, batch);
      });
  press_batch(grains, batch);
}

template <typename Batch>
void RigidWall::press_batch(const GrainArrays& grains, Batch& batch)
{
  context_.resolve(batch, advance_memory_);
  const double step = static_cast<double>(update->ntimestep);
  for (int n = 0; n < batch.count(); ++n) {
    const int i = batch.i(n);
    const ContactStiffness stiffness = batch.stiffness(n);
    if (batch.is_new(n, step) || all_are_new_) context_.raise_mass_for_contact(i, stiffness);
    as_vec3(grains.force + 3 * i) += batch.force(n);
    as_vec3(grains.moment + 3 * i) += batch.moment_i(n);
    own_load_.force += batch.normal_force(n);
    own_load_.stiffness += stiffness.normal;
  }
  batch.clear();
}

}  // namespace encased_column
