#include "servo/fix_servo_cylinder.h"

#include "core/input_error.h"
#include "core/read_number.h"
#include "host/find_fix.h"
#include "host/rank_sums.h"
#include "host/wall_mover.h"
#include "servo/fix_servo_platen.h"
#include "servo/prism.h"

#include <cmath>

namespace encased_column {

const KeywordTable FixServoCylinder::keywords{
    rigid_wall_keywords(),
    {
        {"platens", 2, "-", "IDs of the two `fix servo/platen` between which the cylinder is loaded"},
        {"axis", 2, "m", "x and y of the axis (default 0 0)"},
    }};

FixServoCylinder::FixServoCylinder(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : RigidWall(lmp, narg, arg)
{
  try {
    const Options options = keywords.read(narg, arg);
    const auto& platens = options.all("platens").front();
    platen_ids_[0] = platens[0];
    platen_ids_[1] = platens[1];
    if (options.has("axis")) {
      const auto& axis = options.all("axis").front();
      center_ = Vec3(read_number("axis", axis[0]), read_number("axis", axis[1]), 0.0);
    }
    options.word("mesh");
    read_motion(options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  vector_flag = 1;
  size_vector = 5;
  global_freq = 1;
  extvector = 0;
}

void FixServoCylinder::init()
{
  RigidWall::init();
  try {
    for (int n = 0; n < 2; ++n)
      platens_[n] = find_fix<FixServoPlaten>(lmp, "platens", platen_ids_[n], "fix servo/platen");
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

// Virtual work of a change of radius: grains at (x, y) from the axis press with F, and
// dW = sum F . (x, y)/R dR. Divided by R it is the force that belongs to dR; with the area
// 2 c R h, c R^2 the cross section, force over area is the stress of p dV exactly, facets or not.
WallLoad FixServoCylinder::local_load() const
{
  WallLoad load;
  for (const WallContact& contact : wall_contacts) {
    const Vec3 arm = contact.point - center_;
    load.force += (contact.force.x() * arm.x() + contact.force.y() * arm.y()) / radius_;
    load.stiffness += contact.normal_stiffness;
  }
  return load;
}

double FixServoCylinder::loaded_area() const
{
  const double height = std::abs(platens_[0]->height() - platens_[1]->height());
  return 2.0 * section_ratio_ * radius_ * height;
}

double FixServoCylinder::enclosed_volume(double z_low, double z_high) const
{
  return cross_section(0.0) * (z_high - z_low);
}

bool FixServoCylinder::holds(const double* center) const
{
  return std::hypot(center[0] - center_.x(), center[1] - center_.y()) < radius_;
}

void FixServoCylinder::advance(WallMover& mover, double distance)
{
  const double stretch = -distance / radius_;
  const double stretch_rate = -speed() / radius_;
  const auto from_axis = [this](const Vec3& x) {
    return Vec3(x.x() - center_.x(), x.y() - center_.y(), 0.0);
  };
  mover.move_nodes([&](const Vec3& x) -> Vec3 { return stretch * from_axis(x); },
                   [&](const Vec3& x) -> Vec3 { return stretch_rate * from_axis(x); });
  radius_ -= distance;
}

void FixServoCylinder::measure(WallMover& mover)
{
  double low = 1e300, high = -1e300, z_low = 1e300, z_high = -1e300, volume = 0.0;
  for (int triangle = 0; triangle < mover.owned(); ++triangle) {
    Vec3 x[3];
    for (int corner = 0; corner < 3; ++corner) {
      x[corner] = mover.node(triangle, corner);
      const double r = std::hypot(x[corner].x() - center_.x(), x[corner].y() - center_.y());
      low = std::min(low, r);
      high = std::max(high, r);
      z_low = std::min(z_low, x[corner].z());
      z_high = std::max(z_high, x[corner].z());
    }
    volume += mantle_volume(x[0], x[1], x[2], center_);
  }
  low = min_over_ranks(low, world);
  high = max_over_ranks(high, world);
  const double height = max_over_ranks(z_high, world) - min_over_ranks(z_low, world);
  if (high - low > 1e-5 * high)
    error->fix_error(FLERR, this, ("'mesh' of a cylinder must have all nodes at one radius about 'axis', found " +
                                   in_words(low) + " to " + in_words(high) +
                                   " m, write the mesh of a cylinder along z").c_str());
  radius_ = 0.5 * (low + high);
  section_ratio_ = sum_over_ranks(volume, world) / (height * radius_ * radius_);
}

double FixServoCylinder::compute_vector(int n)
{
  switch (n) {
    case 0: return confining_stress();
    case 1: return load().force;
    case 2: return radius_;
    case 3: return speed();
    default: return work();
  }
}

}  // namespace encased_column
