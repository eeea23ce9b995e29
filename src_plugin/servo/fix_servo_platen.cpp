#include "servo/fix_servo_platen.h"

#include "core/constants.h"
#include "core/input_error.h"
#include "host/find_fix.h"
#include "host/rank_sums.h"
#include "host/wall_mover.h"

#include <cmath>
#include <vector>

namespace encased_column {


const KeywordTable FixServoPlaten::keywords{
    rigid_wall_keywords(),
    {
        {"position", 1, "-", "`top` or `bottom` of the specimen"},
        {"side", 1, "-", "ID of the specimen's lateral boundary, whose cross section carries the load"},
        {"area", 1, "m^2", "instead of `side`: a constant area"},
    }};

FixServoPlaten::FixServoPlaten(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : RigidWall(lmp, narg, arg)
{
  try {
    const Options options = keywords.read(narg, arg);
    outward_ = options.choice("position", {"top", "bottom"}) == "top" ? 1.0 : -1.0;
    if (options.has("side") == options.has("area"))
      throw InputError("a platen takes one of 'side' and 'area', found " +
                       std::string(options.has("side") ? "both" : "neither") +
                       ", write 'side ID' or 'area 0.00785'");
    if (options.has("area")) area_ = options.positive("area");
    side_id_ = options.word("side", "");
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

void FixServoPlaten::init()
{
  RigidWall::init();
  if (side_id_.empty()) return;
  try {
    side_ = find_fix<SpecimenSide>(lmp, "side", side_id_, "cylinder or sleeve");
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

WallLoad FixServoPlaten::local_load() const
{
  WallLoad load;
  for (const WallContact& contact : wall_contacts) {
    load.force += outward_ * contact.force.z();
    load.stiffness += contact.normal_stiffness;
  }
  return load;
}

double FixServoPlaten::loaded_area() const
{
  return side_ ? side_->cross_section(z_) : area_;
}

double FixServoPlaten::stress() const
{
  return load().force / loaded_area();
}

double FixServoPlaten::usual_speed_limit() const
{
  return 1e-4 * std::sqrt(loaded_area() / pi) / update->dt;
}

void FixServoPlaten::advance(WallMover& mover, double distance)
{
  const Vec3 inward(0.0, 0.0, -outward_);
  z_ += inward.z() * distance;
  mover.move_nodes([&](const Vec3&) -> Vec3 { return distance * inward; },
                   [&](const Vec3&) -> Vec3 { return speed() * inward; });
}

void FixServoPlaten::measure(WallMover& mover)
{
  double low = 1e300, high = -1e300, width = 0.0;
  for (int triangle = 0; triangle < mover.owned(); ++triangle)
    for (int corner = 0; corner < 3; ++corner) {
      low = std::min(low, mover.node(triangle, corner).z());
      high = std::max(high, mover.node(triangle, corner).z());
      width = std::max(width, std::abs(mover.node(triangle, corner).x()));
    }
  low = min_over_ranks(low, world);
  high = max_over_ranks(high, world);
  if (high - low > 1e-6 * max_over_ranks(width, world))
    error->fix_error(FLERR, this, ("'mesh' of a platen must be flat across z, found heights from " +
                                   in_words(low) + " to " + in_words(high) +
                                   " m, write a mesh of one height").c_str());
  z_ = 0.5 * (low + high);
}

double FixServoPlaten::compute_vector(int n)
{
  switch (n) {
    case 0: return stress();
    case 1: return load().force;
    case 2: return z_;
    case 3: return speed();
    default: return work_on_grains();
  }
}

}  // namespace encased_column
