// SPDX-License-Identifier: GPL-2.0-only
#include "servo/fix_servo_cylinder.h"

#include "core/input_error.h"
#include "host/grains_and_box.h"

namespace encased_column {

const KeywordTable FixServoCylinder::keywords{
    WallMotion::keywords(),
    {
        {"radius", 1, "m", "of the inner surface at the start, larger than zero"},
        {"platens", 2, "-", "IDs of the upper and the lower `fix servo/platen`"},
        {"axis", 2, "m", "x and y of the axis (default 0 0)"},
    }};

FixServoCylinder::FixServoCylinder(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : RigidWall(lmp, narg, arg),
      platens_(lmp)
{
  try {
    const Options options = keywords.read(narg, arg);
    cylinder_.radius = options.positive("radius");
    platens_.read(options);
    if (options.has("axis")) {
      const auto& axis = options.all("axis").front();
      cylinder_.x = read_number("axis", axis[0]);
      cylinder_.y = read_number("axis", axis[1]);
    }
    options.assume("axis", "0 0");
    read_wall(options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

void FixServoCylinder::find_partners()
{
  require_open_box(lmp, "servo/cylinder", "xy");
  platens_.find();
}

// Before the first run, and when a platen was taken away, there is no area.
double FixServoCylinder::confining_stress() const
{
  return has_partners() ? load().stress_on(loaded_area()) : 0.0;
}

double FixServoCylinder::loaded_area() const
{
  return cylinder_.lateral_area(platens_.now().window().height());
}

void FixServoCylinder::advance(double distance)
{
  cylinder_.advance(distance);
  if (cylinder_.radius > 0.0) return;
  error->fix_error(FLERR, this,
                   ("'radius' must stay larger than zero, found " + in_words(cylinder_.radius) +
                    " m at step " + std::to_string(update->ntimestep) +
                    ", write a lower speed or 'fix_modify " + id + " hold' before it gets there")
                       .c_str());
}

double FixServoCylinder::compute_vector(int n)
{
  switch (n) {
    case 0:
      return confining_stress();
    case 1:
      return load().force;
    case 2:
      return cylinder_.radius;
    case 3:
      return speed();
    case 4:
      return work();
    default:
      return ramp_left();
  }
}

}  // namespace encased_column
