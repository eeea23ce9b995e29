#include "measure/fix_measure_sphere.h"

#include "core/input_error.h"
#include "host/rank_sums.h"
#include "host/restart_block.h"
#include "host/stop_run.h"
#include "measure/sphere_overlap.h"
#include "output/output_places.h"
#include "output/vtk_spheres_writer.h"
#include "servo/find_platens.h"

#include <algorithm>
#include <type_traits>

namespace encased_column {

namespace {

/// Fewer and the numbers of a sphere depend on where it stands.
/// Source: the study, section 2.2.2.
constexpr double fewest_grains = 2000.0;

const std::vector<std::string> columns{"step [-]",
                                       "sphere [-]",
                                       "x [m]",
                                       "y [m]",
                                       "z [m]",
                                       "radius [m]",
                                       "grains [-]",
                                       "porosity [-]",
                                       "porosity_less_overlap [-]",
                                       "coordination_number [-]",
                                       "coordination_number_bearing [-]",
                                       "axial_stress [Pa]",
                                       "radial_stress [Pa]",
                                       "hoop_stress [Pa]",
                                       "stress_xx [Pa]",
                                       "stress_yy [Pa]",
                                       "stress_zz [Pa]",
                                       "stress_xy [Pa]",
                                       "stress_xz [Pa]",
                                       "stress_yz [Pa]",
                                       "fabric_xx [-]",
                                       "fabric_yy [-]",
                                       "fabric_zz [-]",
                                       "fabric_xy [-]",
                                       "fabric_xz [-]",
                                       "fabric_yz [-]",
                                       "sliding_fraction [-]",
                                       "mean_contact_force [N]",
                                       "largest_contact_force [N]"};

/// The six numbers of a tensor, the mean of both triangles off the diagonal.
std::vector<double> six(const Mat3& t)
{
  const auto off = [&t](int a, int b) { return 0.5 * (t(a, b) + t(b, a)); };
  return {t(0, 0), t(1, 1), t(2, 2), off(0, 1), off(0, 2), off(1, 2)};
}

}  // namespace

const KeywordTable FixMeasureSphere::keywords{
    {"sphere", 4, "m", "x, y, z and radius of a sphere that stands still (may be repeated)", true},
    {"stack", 2, "-, m", "number and radius of spheres one above the other between the platens"},
    {"platens", 2, "-", "with `stack`: IDs of the upper and the lower `fix servo/platen`"},
    {"axis", 2, "m", "x and y of the column's axis (default 0 0)"},
    {"every", 1, "steps", "steps between samples (default 1000)"},
    {"file", 1, "-", "CSV file (default spheres.csv)"},
    {"folder", 1, "-", "folder of VTK files, created if missing (default: none are written)"},
    {"name", 1, "-", "name of their series (default spheres)"},
};

FixMeasureSphere::FixMeasureSphere(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : LAMMPS_NS::Fix(lmp, narg, arg),
      file_("", {}),
      clock_(lmp)
{
  try {
    const Options options = keywords.read(narg, arg);
    read_spheres(options);
    nevery = static_cast<int>(options.integer("every", 1, 1000));
    const std::string file = options.word("file", "spheres.csv");
    require_writable(lmp, "file", file, file);
    file_ = CsvSeries(file, columns);
    if (options.has("folder")) series_ = series_of(lmp, options, "spheres");
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  restart_global = 1;
  array_flag = 1;
  size_array_rows = static_cast<int>(spheres_.size());
  size_array_cols = static_cast<int>(columns.size());
  global_freq = 1;
  extarray = 0;
  rows_.assign(spheres_.size(), std::vector<double>(columns.size(), 0.0));
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
  if (stack_ == 0) return;
  try {
    find_platens(lmp, platen_ids_, platens_);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

bool FixMeasureSphere::wants_contacts(LAMMPS_NS::bigint step) const
{
  return setting_up_ || step % nevery == 0;
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

void FixMeasureSphere::add_contact(const Contact& contact)
{
  const bool pair_here = contact.j >= 0 && contact.j < atom->nlocal;
  ++contacts_of_[contact.i];
  if (pair_here) ++contacts_of_[contact.j];
  const double radius = atom->radius[contact.i];
  const double volume =
      contact.j < 0 ? sphere_cap_volume(radius, contact.length)
                    : sphere_overlap_volume(radius, atom->radius[contact.j], contact.length);
  const Vec3 x = as_vec3(atom->x[contact.i]);
  const double force = contact.force.norm();
  for (std::size_t n = 0; n < spheres_.size(); ++n) {
    const MeasuringSphere& sphere = spheres_[n];
    const Vec3 point = x + contact.arm * contact.normal;
    add_contact_end(sums_[n], sphere, x, contact.force, contact.arm * contact.normal);
    if (pair_here)
      add_contact_end(sums_[n], sphere, as_vec3(atom->x[contact.j]), -contact.force,
                      -(contact.length - contact.arm) * contact.normal);
    encased_column::add_contact(sums_[n], sphere, point, contact.normal, volume, force,
                                contact.sliding, contact.share);
    if (sphere.holds(point)) largest_force_[n] = std::max(largest_force_[n], force);
  }
}

// The first row is the state before the first step.
void FixMeasureSphere::setup(int)
{
  clock_.begin_run();
  if (sampled_) return;
  take_sample();
  write();
}

void FixMeasureSphere::end_of_step()
{
  take_sample();
  write();
}

void FixMeasureSphere::take_sample()
{
  static_assert(std::is_trivially_copyable_v<SphereSums>);
  sampled_ = true;
  for (std::size_t n = 0; n < spheres_.size(); ++n) {
    for (int i = 0; i < atom->nlocal; ++i)
      add_grain(sums_[n], spheres_[n], as_vec3(atom->x[i]), atom->radius[i], contacts_of_[i]);
    largest_force_[n] = max_over_ranks(largest_force_[n], world);
  }
  sum_over_ranks(&sums_.front().solid,
                 static_cast<int>(sums_.size() * sizeof(SphereSums) / sizeof(double)), world);
  for (std::size_t n = 0; n < spheres_.size(); ++n) {
    const MeasuringSphere& sphere = spheres_[n];
    const SphereMeasure m = measure(sums_[n], sphere);
    std::vector<double>& row = rows_[n];
    row = {static_cast<double>(update->ntimestep),
           static_cast<double>(n + 1),
           sphere.center.x(),
           sphere.center.y(),
           sphere.center.z(),
           sphere.radius,
           m.grains,
           m.porosity,
           m.porosity_less_overlap,
           m.coordination_number,
           m.coordination_number_bearing,
           m.axial,
           m.radial,
           m.hoop};
    for (const double number : six(m.stress)) row.push_back(number);
    for (const double number : six(m.fabric)) row.push_back(number);
    row.insert(row.end(), {m.sliding_fraction, m.mean_force, largest_force_[n]});
  }
  warn_of_few_grains();
}

void FixMeasureSphere::warn_of_few_grains()
{
  if (warned_) return;
  for (std::size_t n = 0; n < spheres_.size(); ++n) {
    if (sums_[n].grains >= fewest_grains) continue;
    warned_ = true;
    if (comm->me == 0)
      error->warning(
          FLERR,
          ("measuring sphere " + std::to_string(n + 1) + " of fix '" + id + "' holds " +
           in_words(sums_[n].grains) + " grains at step " + std::to_string(update->ntimestep) +
           ", take a larger one: below 2000 its numbers depend on where it stands")
              .c_str());
    return;
  }
}

void FixMeasureSphere::write()
{
  if (comm->me != 0) return;
  std::vector<double> block;
  for (const std::vector<double>& row : rows_) block.insert(block.end(), row.begin(), row.end());
  if (!file_.append(block)) stop(file_.path());
  if (!series_) return;
  const long step = static_cast<long>(update->ntimestep);
  const std::string path = series_->path_of_step(step);
  if (!write_spheres(path, columns, rows_) || !series_->list(clock_.now(), step)) stop(path);
}

void FixMeasureSphere::stop(const std::string& path) const
{
  stop_from_one_rank(lmp, "fix measure/sphere cannot write '" + path +
                              "', free some space or mend the folder's rights");
}

double FixMeasureSphere::compute_array(int sphere, int column)
{
  return rows_[sphere][column];
}

/// The time and the rows as they are, then the series as text.
void FixMeasureSphere::write_restart(FILE* file)
{
  if (comm->me != 0) return;
  std::vector<double> numbers{clock_.now()};
  for (const std::vector<double>& row : rows_)
    numbers.insert(numbers.end(), row.begin(), row.end());
  write_block(file, numbers, series_ ? series_->saved() : "");
}

void FixMeasureSphere::restart(char* buffer)
{
  RestartBlock block(buffer);
  clock_.restart(block.take());
  for (std::vector<double>& row : rows_) block.take(row.data(), row.size());
  sampled_ = true;
  if (comm->me != 0) return;
  if (!file_.go_back_to(static_cast<double>(update->ntimestep))) stop(file_.path());
  if (series_ && !series_->restore(block.text()))
    stop(series_->path_of_step(static_cast<long>(update->ntimestep)));
}

}  // namespace encased_column
