#include "servo/fix_servo_cylinder.h"

#include "core/read_number.h"
#include "host/find_fix.h"
#include "servo/fix_servo_platen.h"

namespace encased_column {

const KeywordTable FixServoCylinder::keywords{
    WallDrive::keywords(),
    {
        {"radius", 1, "m", "of the inner surface at the start, larger than zero"},
        {"platens", 2, "-", "IDs of the two `fix servo/platen` between which it is loaded"},
        {"axis", 2, "m", "x and y of the axis (default 0 0)"},
    }};

FixServoCylinder::FixServoCylinder(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : RigidWall(lmp, narg, arg)
{
  try {
    const Options options = keywords.read(narg, arg);
    cylinder_.radius = options.positive("radius");
    for (int n = 0; n < 2; ++n) platen_ids_[n] = options.all("platens").front()[n];
    if (options.has("axis")) {
      const auto& axis = options.all("axis").front();
      cylinder_.x = read_number("axis", axis[0]);
      cylinder_.y = read_number("axis", axis[1]);
    }
    read_wall(options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

// The same on every rank.
void FixServoCylinder::advance(double distance)
{
  cylinder_.advance(distance);
  if (cylinder_.radius <= 0.0)
    error->fix_error(FLERR, this,
                     ("the cylinder must stay open, found it closed to a radius of 0 at step " +
                      std::to_string(update->ntimestep) + ", stop it before by 'fix_modify " + id +
                      " hold' or write a smaller 'velocity' or 'speed_limit'")
                         .c_str());
}

void FixServoCylinder::find_partners()
{
  for (int n = 0; n < 2; ++n)
    platens_[n] = find_fix<FixServoPlaten>(lmp, "platens", platen_ids_[n], "fix servo/platen");
}

bool FixServoCylinder::has_partners() const
{
  return is_there(lmp, platens_[0]) && is_there(lmp, platens_[1]);
}

double FixServoCylinder::confining_stress() const
{
  // Before the first run, and when a platen was taken away, there is no area.
  return has_partners() ? load().force / loaded_area() : 0.0;
}

double FixServoCylinder::loaded_area() const
{
  const double height = std::abs(platens_[0]->height() - platens_[1]->height());
  return 2.0 * pi * cylinder_.radius * height;
}

double FixServoCylinder::enclosed_volume(double z_low, double z_high) const
{
  return cylinder_.cross_section() * (z_high - z_low);
}

int FixServoCylinder::count_outside(const double* centers, int count, double z_low,
                                    double z_high) const
{
  int outside = 0;
  for (const double* x = centers; x != centers + 3 * count; x += 3)
    outside += x[2] < z_low || x[2] > z_high || cylinder_.overlap(x, 0.0) >= 0.0;
  return outside;
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
