// SPDX-License-Identifier: GPL-2.0-only
#include "packing/create_packing_command.h"

#include "core/input_error.h"
#include "host/output_files.h"
#include "packing/draw_diameters.h"
#include "packing/gradation_file.h"
#include "packing/grain_volume.h"
#include "packing/packing_limits.h"

#include "atom_vec.h"

#include <cstdio>
#include <fstream>
#include <sstream>

namespace encased_column {

const KeywordTable CreatePackingCommand::keywords{
    {"gradation", 1, "-", "CSV file of the size classes"},
    {"distribution", 1, "-", "inside a class: log_uniform, uniform or uniform_number"},
    {"cylinder", 3, "m", "radius, lower and upper end of the specimen around the z axis"},
    {"porosity", 1, "-", "voids over volume at full size, 0.1 to 0.7"},
    {"relative_density", 1, "-", "instead of `porosity`: 0 for the loosest packing to 1"},
    {"limits", 3, "-",
     "with `relative_density`: CSV file of packing limits, friction and rolling friction"},
    {"density", 1, "kg/m^3", "of the grains, larger than zero"},
    {"type", 1, "-", "atom type of the grains"},
    {"seed", 1, "-", "of the random draws, zero or larger"},
    {"start_factor", 1, "-", "radius when placed over full radius, 0.01 to 1"},
    {"finest", 1, "m", "grains below this diameter are left out"},
    {"report", 1, "-", "CSV file for the gradation achieved"},
};

void CreatePackingCommand::command(int narg, char** arg)
{
  try {
    const Options options = keywords.read(narg, arg, 0);
    const std::vector<std::string>& ends = options.all("cylinder").front();
    const Vec3 size = options.vector("cylinder");
    const Cylinder cylinder{size[0], size[1], size[2]};
    if (!(cylinder.radius > 0.0 && cylinder.height() > 0.0))
      throw InputError(
          "'cylinder' takes a radius larger than zero, a lower and a higher end, found " + ends[0] +
          " " + ends[1] + " " + ends[2] + ", write for example 'cylinder 0.05 0 0.2'");
    const double density = options.positive("density");
    const long type = options.integer("type", 1);
    const auto seed = static_cast<std::uint64_t>(options.integer("seed", 0));
    const double start_factor = options.between("start_factor", 0.01, 1.0, 0.5);
    const ClassDistribution distribution =
        class_distribution(options.word("distribution", "log_uniform"));
    const double finest = options.not_negative("finest", 0.0);
    check_host(cylinder, type);
    const double solid = solid_volume(read_porosity(options, cylinder, finest), cylinder.volume());
    OutputFiles files(lmp, "create_packing");
    const std::string report_file = options.has("report") ? files.file(options, "report", "") : "";

    std::istringstream table(read_file("gradation", options.word("gradation")));
    const Gradation gradation =
        without_finer(read_gradation(table, options.word("gradation")), distribution, finest);
    const std::vector<double> diameters = draw_diameters(gradation, distribution, solid, seed);
    std::vector<double> radii;
    radii.reserve(diameters.size());
    for (const double d : diameters) radii.push_back(start_factor * 0.5 * d);
    // Sizes and places must not share one sequence of random numbers.
    const std::vector<Vec3> centers = place_spheres(radii, cylinder, ~seed);

    report(gradation, diameters, cylinder.volume(), report_file);
    create_atoms(centers, radii, static_cast<int>(type), density);
    check_created(centers.size());
  } catch (const InputError& problem) {
    error->all(FLERR, (std::string("create_packing: ") + problem.what()).c_str());
  }
}

void CreatePackingCommand::check_host(const Cylinder& cylinder, long type) const
{
  if (!domain->box_exist)
    throw InputError("there must be a box, found none yet, write 'create_box' before it");
  if (!atom->radius_flag || !atom->rmass_flag || !atom->density_flag)
    throw InputError("atoms must have a radius and a density, found 'atom_style " +
                     std::string(atom->atom_style) + "', write 'atom_style granular'");
  if (domain->triclinic)
    throw InputError("the box must not be tilted, found xy = " + in_words(domain->xy) +
                     ", xz = " + in_words(domain->xz) + " and yz = " + in_words(domain->yz) +
                     ", write a region of style block for 'create_box'");
  if (atom->natoms > 0)
    throw InputError("the box must be empty, found " + std::to_string(atom->natoms) +
                     " grains, create the packing first");
  if (type > atom->ntypes)
    throw InputError("'type' must be between 1 and " + std::to_string(atom->ntypes) + ", found " +
                     std::to_string(type) + ", or give 'create_box' more types");
  const Vec3 low(-cylinder.radius, -cylinder.radius, cylinder.z_low);
  const Vec3 high(cylinder.radius, cylinder.radius, cylinder.z_high);
  for (int k = 0; k < 3; ++k)
    if (low[k] < domain->boxlo[k] || high[k] > domain->boxhi[k])
      throw InputError("'cylinder' must lie in the box, found " + in_words(low[k]) + " to " +
                       in_words(high[k]) + " m along " + "xyz"[k] + " in a box from " +
                       in_words(domain->boxlo[k]) + " to " + in_words(domain->boxhi[k]) +
                       " m, enlarge the box");
}

double CreatePackingCommand::read_porosity(const Options& options, const Cylinder& cylinder,
                                           double finest) const
{
  const bool relative = options.has("relative_density");
  if (relative == options.has("porosity"))
    throw InputError("a packing takes one of 'porosity' and 'relative_density', found " +
                     std::string(relative ? "both" : "neither") +
                     ", write for example 'porosity 0.4'");
  if (relative != options.has("limits"))
    throw InputError(
        "'relative_density' and 'limits' stand together, found one of them, write for example "
        "'relative_density 0.8 limits packing_limits.csv 0.7 0.5'");
  if (!relative) return options.number("porosity");
  const double density = options.between("relative_density", 0.0, 1.0);
  const std::vector<std::string>& words = options.all("limits").front();
  const std::string gradation = options.word("gradation");
  const PackingCase packing{gradation.substr(gradation.rfind('/') + 1),
                            options.word("distribution", "log_uniform"),
                            finest,
                            cylinder.radius,
                            cylinder.height(),
                            read_number("limits", words[1]),
                            read_number("limits", words[2])};
  std::istringstream table(read_file("limits", words[0]));
  return read_packing_limits(table, words[0], packing).porosity_at(density);
}

std::string CreatePackingCommand::read_file(const std::string& keyword,
                                            const std::string& file) const
{
  std::string text;
  int size = -1;
  if (comm->me == 0) {
    std::ifstream in(file);
    std::ostringstream all;
    // A folder opens like a file and fails only here.
    if (in && all << in.rdbuf()) {
      text = all.str();
      size = static_cast<int>(text.size());
    }
  }
  MPI_Bcast(&size, 1, MPI_INT, 0, world);
  if (size < 0)
    throw InputError("'" + keyword + "' must name a file that can be read, found '" + file +
                     "', check the path from where the deck runs");
  text.resize(static_cast<std::size_t>(size));
  MPI_Bcast(text.data(), size, MPI_CHAR, 0, world);
  return text;
}

void CreatePackingCommand::report(const Gradation& wanted, const std::vector<double>& diameters,
                                  double volume, const std::string& file) const
{
  const std::vector<ClassContent> achieved = sieve(wanted, diameters);
  const PackingSummary summary{
      diameters.size(), porosity_of(diameters, volume),
      characteristic_sizes(sieved_gradation(wanted, achieved), ClassDistribution::log_uniform),
      characteristic_sizes(diameters)};
  int written = 1;
  if (comm->me == 0) {
    print(summary);
    if (!file.empty()) {
      std::ofstream out(file);
      write_gradation(out, wanted, achieved, summary);
      written = out.flush() ? 1 : 0;
    }
  }
  MPI_Bcast(&written, 1, MPI_INT, 0, world);
  if (!written)
    throw InputError("'report' must name a file that can be written, found '" + file +
                     "', make its folder first");
}

void CreatePackingCommand::print(const PackingSummary& summary) const
{
  for (FILE* out : {screen, logfile}) {
    if (!out) continue;
    std::fprintf(out, "Packing: %zu grains, porosity %.4f at full size\n", summary.count,
                 summary.porosity);
    for (const auto& [by, sizes] :
         {std::pair("sieve", summary.by_sieve), std::pair("grain", summary.by_grain)})
      std::fprintf(out, "  by %s: d10 %.3f mm, d30 %.3f mm, d60 %.3f mm, Cu %.2f, Cc %.2f\n", by,
                   1e3 * sizes.d10, 1e3 * sizes.d30, 1e3 * sizes.d60, sizes.uniformity(),
                   sizes.curvature());
  }
}

// The bookkeeping after new atoms follows the host's own create_atoms.
void CreatePackingCommand::create_atoms(const std::vector<Vec3>& centers,
                                        const std::vector<double>& radii, int type, double density)
{
  for (std::size_t n = 0; n < centers.size(); ++n) {
    Vec3 center = centers[n];
    if (!domain->is_in_subdomain(center.data())) continue;
    atom->avec->create_atom(type, center.data());
    const int i = atom->nlocal - 1;
    atom->tag[i] = static_cast<int>(n) + 1;
    atom->radius[i] = radii[n];
    atom->density[i] = density;
    atom->rmass[i] = grain_mass(radii[n], density);
  }
  for (int m = 0; m < modify->nfix; ++m) {
    LAMMPS_NS::Fix* fix = modify->fix[m];
    if (!fix->create_attribute) continue;
    fix->pre_set_arrays();
    for (int i = 0; i < atom->nlocal; ++i) fix->set_arrays(i);
  }
  const LAMMPS_NS::bigint owned = atom->nlocal;
  MPI_Allreduce(&owned, &atom->natoms, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (atom->map_style) {
    atom->nghost = 0;
    atom->map_init();
    atom->map_set();
  }
}

void CreatePackingCommand::check_created(std::size_t wanted) const
{
  if (atom->natoms != static_cast<LAMMPS_NS::bigint>(wanted))
    throw InputError("the box must hold every grain, found " + std::to_string(atom->natoms) +
                     " of " + std::to_string(wanted) + " inside, enlarge the box");
}

}  // namespace encased_column
