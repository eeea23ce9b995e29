// SPDX-License-Identifier: GPL-2.0-only
#include "servo/fix_servo_platen.h"

#include "host/grains_and_box.h"

namespace encased_column {

const KeywordTable FixServoPlaten::keywords{
    WallMotion::keywords(),
    {
        {"position", 1, "-", "`top` or `bottom` of the specimen"},
        {"z", 1, "m", "height of its face at the start"},
        {"side", 1, "-", "ID of the specimen's side, whose cross section carries the load"},
        {"area", 1, "m^2", "instead of `side`: a constant area"},
    }};

FixServoPlaten::FixServoPlaten(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : RigidWall(lmp, narg, arg),
      side_(lmp)
{
  try {
    const Options options = keywords.read(narg, arg);
    plane_.outward = options.choice("position", {"top", "bottom"}) == "top" ? 1.0 : -1.0;
    plane_.z = options.number("z");
    if (options.has("side") == options.has("area"))
      throw InputError("a platen takes one of 'side' and 'area', found " +
                       std::string(options.has("side") ? "both" : "neither") +
                       ", write 'side ID' or 'area 0.00785'");
    if (options.has("area")) area_ = options.positive("area");
    if (options.has("side")) side_.name("side", options.word("side"), "cylinder or sleeve");
    read_wall(options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

void FixServoPlaten::find_partners()
{
  require_open_box(lmp, "servo/platen", "z");
  if (side_.is_named()) side_.find();
}

bool FixServoPlaten::has_partners() const
{
  return !side_.is_named() || side_.is_there();
}

// Before the first run, and when the side was taken away, there is no area.
double FixServoPlaten::stress() const
{
  return has_partners() ? load().stress_on(loaded_area()) : 0.0;
}

double FixServoPlaten::loaded_area() const
{
  return side_.is_named() ? side_->cross_section(plane_.z) : area_;
}

double FixServoPlaten::mean_radius() const
{
  return radius_of_section(loaded_area());
}

double FixServoPlaten::compute_vector(int n)
{
  switch (n) {
    case 0:
      return stress();
    case 1:
      return force();
    case 2:
      return height();
    case 3:
      return speed();
    case 4:
      return work();
    default:
      return ramp_left();
  }
}

}  // namespace encased_column
