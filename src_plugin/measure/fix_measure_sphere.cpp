#include "measure/fix_measure_sphere.h"

#include "host/box_of_run.h"
#include "host/say_understood.h"
#include "servo/find_platens.h"

#include <numeric>

namespace encased_column {

const KeywordTable FixMeasureSphere::keywords{
    {"sphere", 4, "m", "x, y, z and radius of a sphere that stands still (may be repeated)", true},
    {"stack", 2, "-, m", "number and radius of spheres one above the other between the platens"},
    {"platens", 2, "-", "with `stack`: IDs of the upper and the lower `fix servo/platen`"},
    {"axis", 2, "m", "x and y of the column's axis (default 0 0)"},
    {"every", 1, "steps", "steps between samples (default 1000)"},
    {"file", 1, "-", "CSV file (default spheres.csv)"},
    {"folder", 1, "-", "folder of VTK files, created if missing (default: none are written)"},
    {"frames", 1, "steps",
     "with `folder`: one VTK file every so many steps (default: those of `every`)"},
    {"name", 1, "-", "name of their series (default spheres)"},
};

FixMeasureSphere::FixMeasureSphere(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg),
      files_(lmp, *this),
      file_("", {}),
      clock_(lmp)
{
  try {
    const Options options = keywords.read(narg, arg);
    read_spheres(options);
    row_every_ = options.integer("every", 1, 1000);
    frame_every_ = options.has("frames") ? options.integer("frames", 1) : row_every_;
    nevery = static_cast<int>(std::gcd(row_every_, frame_every_));
    file_ = CsvSeries(files_.file(options, "file", "spheres.csv"), columns());
    if (options.has("frames") && !options.has("folder"))
      throw InputError(
          "'frames' goes with 'folder', found it alone, write for example 'folder spheres'");
    if (options.has("folder")) {
      series_ = files_.series(options, "spheres");
      options.assume("frames", std::to_string(frame_every_));
    }
    options.assume("axis", "0 0");
    say_understood(lmp, *this, options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  restart_global = 1;
  array_flag = 1;
  size_array_rows = static_cast<int>(spheres_.size());
  size_array_cols = static_cast<int>(columns().size());
  global_freq = 1;
  extarray = 0;
  rows_.assign(spheres_.size(), std::vector<double>(columns().size(), 0.0));
}

void FixMeasureSphere::read_spheres(const Options& options)
{
  Vec3 axis = Vec3::Zero();
  const auto number_at = [](const std::vector<std::string>& words, int n) {
    static const KeywordTable one{{"sphere", 1, "m", ""}};
    return one.read({"sphere", words[n]}).number("sphere");
  };
  if (options.has("axis"))
    for (int a = 0; a < 2; ++a) axis(a) = number_at(options.all("axis").front(), a);
  const auto add = [&](const Vec3& center, double radius) {
    if (!(radius > 0.0))
      throw InputError("the radius of a measuring sphere must be larger than zero, found " +
                       in_words(radius) + ", write a length in m");
    spheres_.push_back({center, radius, axis});
  };
  if (options.has("sphere"))
    for (const auto& words : options.all("sphere"))
      add({number_at(words, 0), number_at(words, 1), number_at(words, 2)}, number_at(words, 3));
  if (options.has("stack") != options.has("platens"))
    throw InputError(
        "'stack' and 'platens' go together, found one of them alone, write for "
        "example 'stack 3 0.04 platens top bottom'");
  if (options.has("stack")) {
    const auto& words = options.all("stack").front();
    const double wanted = number_at(words, 0);
    if (!(wanted >= 1.0 && wanted <= 1000.0 && wanted == std::floor(wanted)))
      throw InputError("'stack' takes a whole number of spheres from 1 to 1000, found " + words[0] +
                       ", write for example 'stack 3 0.04'");
    stack_ = static_cast<int>(wanted);
    for (int n = 0; n < stack_; ++n) add(axis, number_at(words, 1));
    for (int n = 0; n < 2; ++n) platen_ids_[n] = options.all("platens").front()[n];
  }
  if (spheres_.empty())
    throw InputError(
        "'measure/sphere' needs 'sphere' or 'stack', found neither, write for example "
        "'sphere 0 0 0.1 0.04'");
}

int FixMeasureSphere::setmask()
{
  using namespace LAMMPS_NS::FixConst;
  return PRE_FORCE | END_OF_STEP;
}

void FixMeasureSphere::init()
{
  try {
    if (stack_ > 0) find_platens(lmp, platen_ids_, platens_);
    files_.check_host();
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

bool FixMeasureSphere::wants_contacts(LAMMPS_NS::bigint step) const
{
  return setting_up_ || step % row_every_ == 0 || step % frame_every_ == 0;
}

void FixMeasureSphere::setup_pre_force(int)
{
  setting_up_ = true;
  clear_sums();
}

void FixMeasureSphere::pre_force(int)
{
  setting_up_ = false;
  if (wants_contacts(update->ntimestep)) clear_sums();
}

void FixMeasureSphere::clear_sums()
{
  place_stack();
  box_ = box_of(lmp);
  contacts_of_.assign(atom->nlocal, 0);
  sums_.assign(spheres_.size(), SphereSums());
  largest_force_.assign(spheres_.size(), 0.0);
}

// From one that touches the lower platen to one that touches the upper; a single one half way.
void FixMeasureSphere::place_stack()
{
  const std::size_t first = spheres_.size() - stack_;
  for (int n = 0; n < stack_; ++n) {
    MeasuringSphere& sphere = spheres_[first + n];
    const double low = platens_[1]->height() + sphere.radius;
    const double high = platens_[0]->height() - sphere.radius;
    const double part = stack_ > 1 ? static_cast<double>(n) / (stack_ - 1) : 0.5;
    sphere.center.z() = low + part * (high - low);
  }
}

// The first row is the state before the first step.
void FixMeasureSphere::setup(int)
{
  clock_.begin_run();
  if (sampled_) return;
  take_sample();
  write_row();
  write_frame();
}

void FixMeasureSphere::end_of_step()
{
  if (!wants_contacts(update->ntimestep)) return;
  take_sample();
  if (update->ntimestep % row_every_ == 0) write_row();
  if (update->ntimestep % frame_every_ == 0) write_frame();
}

}  // namespace encased_column
