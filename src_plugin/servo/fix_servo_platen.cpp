#include "servo/fix_servo_platen.h"

#include "host/box_of_run.h"
#include "host/find_fix.h"

namespace encased_column {

const KeywordTable FixServoPlaten::keywords{
    WallDrive::keywords(),
    {
        {"position", 1, "-", "`top` or `bottom` of the specimen"},
        {"z", 1, "m", "height of its face at the start"},
        {"side", 1, "-", "ID of the specimen's side, whose cross section carries the load"},
        {"area", 1, "m^2", "instead of `side`: a constant area"},
    }};

FixServoPlaten::FixServoPlaten(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : RigidWall(lmp, narg, arg)
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
    if (options.has("side")) side_id_ = options.word("side");
    read_wall(options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

void FixServoPlaten::find_partners()
{
  require_open_box(lmp, "servo/platen", "z");
  side_ = nullptr;
  if (!side_id_.empty())
    side_ = find_fix<SpecimenSide>(lmp, "side", side_id_, "cylinder or sleeve");
}

bool FixServoPlaten::has_partners() const
{
  return side_id_.empty() || is_there(lmp, side_);
}

// Before the first run, and when the side was taken away, there is no area.
double FixServoPlaten::stress() const
{
  return has_partners() ? load().force / loaded_area() : 0.0;
}

double FixServoPlaten::loaded_area() const
{
  return side_ ? side_->cross_section(plane_.z) : area_;
}

double FixServoPlaten::usual_speed_limit() const
{
  return 1e-5 * std::sqrt(loaded_area() / pi) / update->dt;
}

double FixServoPlaten::compute_vector(int n)
{
  switch (n) {
    case 0:
      return stress();
    case 1:
      return load().force;
    case 2:
      return height();
    case 3:
      return speed();
    case 4:
      return work_on_grains();
    default:
      return ramp_left();
  }
}

}  // namespace encased_column
