#include "shell/fix_mesh_surface_shell.h"

#include "host/find_fix.h"
#include "host/rank_sums.h"
#include "servo/find_platens.h"
#include "shell/cylinder_mesh.h"
#include "shell/enclosed_volume.h"
#include "shell/mesh_file.h"

#include "pair_gran.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace encased_column {

const KeywordTable FixMeshSurfaceShell::keywords{
    {"cylinder", 3, "m", "a generated sleeve about the z axis: radius, lower and upper end"},
    {"edge", 1, "m", "edge of its facets, larger than zero"},
    {"file", 1, "-",
     "instead of `cylinder`: mesh from a .stl, .vtk or .vtp file, about an axis along z"},
    {"type", 1, "-", "atom type that stands for the material of the sleeve"},
    {"platens", 2, "-", "IDs of the upper and the lower `fix servo/platen`"},
    {"modulus", 1, "Pa", "Young's modulus, of the hoop direction if `modulus_axial` is given"},
    {"poisson", 1, "-", "Poisson's ratio, -1 to 0.5"},
    {"thickness", 1, "m", "of the membrane, larger than zero"},
    {"bending_thickness", 1, "m", "that bending feels, zero or larger (default: the thickness)"},
    {"density", 1, "kg/m^3", "larger than zero"},
    {"modulus_axial", 1, "Pa", "Young's modulus along the axis (default: isotropic)"},
    {"shear_modulus", 1, "Pa", "needed with `modulus_axial`"},
    {"tension_only", 1, "-",
     "`yes`: the membrane wrinkles instead of bearing compression (default `no`)"},
    {"top_end", 1, "-", "`held` (default), `clamped`, `radial`, `platen` or `free`"},
    {"bottom_end", 1, "-", "the same for the lower end"},
    {"rigid", 1, "-", "`yes`: the sleeve stands still until it is released by `no` (default)"},
    {"pressure", 1, "Pa", "from outside, on what lies between the platens (default 0)"},
    {"ramp", 1, "steps", "with `pressure`: it gets there linearly in so many steps"},
    {"pressed", 1, "-", "`between` the platens (default) or `everywhere`"},
    {"damping", 1, "-", "local damping alpha, 0 to 0.99 (default 0.7)"},
    {"mass_scaling", 1, "-",
     "`yes` (default): nodes as heavy as the step asks for; `no`: true masses"},
    {"safety", 1, "-", "fraction f of the step sqrt(m/k), 0.01 to 1.9 (default 0.8)"},
    {"every", 1, "steps", "how often masses and safety are looked at (default 50)"},
    {"strain_limit", 1, "-", "largest principal strain of a facet, either way (default 0.5)"},
    {"rupture", 1, "N/m", "hoop tension above which the log gets a warning (default: none)"},
};

namespace {

const std::vector<std::string> yes_no{"yes", "no"};

/// Outward facets, whatever way the file turns them.
void face_outward(SurfaceMesh& mesh)
{
  const int facets = static_cast<int>(mesh.facet.size());
  if (enclosed_volume(mesh.facet, mesh.node, 0, facets, HeightWindow()) > 0.0) return;
  for (Facet& facet : mesh.facet) std::swap(facet[1], facet[2]);
}

double mean_height(const std::vector<int>& nodes, const SurfaceMesh& mesh)
{
  double sum = 0.0;
  for (const int node : nodes) sum += mesh.node[node].z();
  return sum / static_cast<double>(nodes.size());
}

}  // namespace

FixMeshSurfaceShell::FixMeshSurfaceShell(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : ContactMemoryFix(lmp, narg, arg),
      desk_(lmp, ContactKind::sleeve)
{
  try {
    const Options options = keywords.read(narg, arg);
    type_ = static_cast<int>(options.integer("type", 1));
    if (type_ > atom->ntypes)
      throw InputError("'type' must be one of the " + std::to_string(atom->ntypes) +
                       " atom types, found " + std::to_string(type_) +
                       ", write a smaller one or make room in 'create_box'");
    for (int n = 0; n < 2; ++n) platen_ids_[n] = options.all("platens").front()[n];
    read_material(options);
    read_mesh(options);
    scale_masses_ = options.choice("mass_scaling", yes_no, "yes") == "yes";
    safety_ = options.between("safety", 0.01, 1.9, 0.8);
    every_ = static_cast<int>(options.integer("every", 1, 50));
    read_changeable(options);
    on_fix_line_ = options;
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  // The host takes whatever is called mesh/surface... for a mesh of its own.
  delete[] style;
  style = std::strcpy(new char[sizeof("sleeve")], "sleeve");
  restart_global = 1;
  vector_flag = 1;
  size_vector = 15;
  global_freq = 1;
  extvector = 0;
}

void FixMeshSurfaceShell::read_material(const Options& options)
{
  constants_.modulus_hoop = options.positive("modulus");
  constants_.poisson = options.number("poisson");
  constants_.thickness = options.positive("thickness");
  constants_.density = options.positive("density");
  constants_.tension_only = options.choice("tension_only", yes_no, "no") == "yes";
  if (options.has("bending_thickness"))
    constants_.bending_thickness = options.not_negative("bending_thickness", 0.0);
  if (options.has("modulus_axial"))
    constants_.modulus_axial = options.positive("modulus_axial");
  else if (options.has("shear_modulus"))
    throw InputError(
        "'shear_modulus' goes with 'modulus_axial', found it alone, give both or neither");
  if (options.has("shear_modulus")) constants_.shear_modulus = options.positive("shear_modulus");
}

void FixMeshSurfaceShell::read_mesh(const Options& options)
{
  if (options.has("cylinder") == options.has("file"))
    throw InputError("a sleeve takes one of 'cylinder' and 'file', found " +
                     std::string(options.has("file") ? "both" : "neither") +
                     ", write for example 'cylinder 0.05 0 0.2 edge 0.005'");
  if (options.has("file") && options.has("edge"))
    throw InputError("'edge' goes with 'cylinder', found it with 'file', whose facets are given");
  SurfaceMesh mesh;
  if (options.has("file")) {
    mesh = read_mesh_file(options.word("file"));
  } else {
    const Vec3 size = options.vector("cylinder");
    mesh = cylinder_mesh(TubeShape{size(0), size(1), size(2) - size(1), options.positive("edge")});
  }
  require_sleeve(mesh);
  face_outward(mesh);
  const auto loops = border_loops(mesh);
  const bool first_is_top = mean_height(loops[0], mesh) > mean_height(loops[1], mesh);
  end_nodes_[0] = loops[first_is_top ? 0 : 1];
  end_nodes_[1] = loops[first_is_top ? 1 : 0];
  require_upright(mesh);
  for (const Vec3& node : mesh.node) axis_ += node / static_cast<double>(mesh.node.size());
  axis_.z() = 0.0;
  pairs_ = facet_pairs(mesh);
  model_ = std::make_unique<ShellModel>(mesh, constants_, Vec3::UnitZ());
  const long facets = model_->facets();
  first_ = static_cast<int>(facets * comm->me / comm->nprocs);
  last_ = static_cast<int>(facets * (comm->me + 1) / comm->nprocs);
}

// Volumes, sections and the pressure's window go by the height.
void FixMeshSurfaceShell::require_upright(const SurfaceMesh& mesh) const
{
  double low = mesh.node[end_nodes_[0].front()].z(), high = mesh.node[end_nodes_[1].front()].z();
  for (const int node : end_nodes_[0]) low = std::min(low, mesh.node[node].z());
  for (const int node : end_nodes_[1]) high = std::max(high, mesh.node[node].z());
  if (low > high) return;
  throw InputError(
      "the axis of a sleeve must stand along z, one end above the other, found the lower "
      "end up to " +
      in_words(high) + " m and the upper one down to " + in_words(low) + " m: turn the mesh");
}

void FixMeshSurfaceShell::read_changeable(const Options& options)
{
  if (options.has("ramp") && !options.has("pressure"))
    throw InputError(
        "'ramp' goes with 'pressure', found it alone, write 'pressure 50e3 ramp 1000'");
  read_pressure(options);
  rigid_ = options.choice("rigid", yes_no, rigid_ ? "yes" : "no") == "yes";
  everywhere_ = options.choice("pressed", {"between", "everywhere"},
                               everywhere_ ? "everywhere" : "between") == "everywhere";
  damping_ = options.between("damping", 0.0, 0.99, damping_);
  if (options.has("strain_limit")) strain_limit_ = options.positive("strain_limit");
  if (options.has("rupture")) rupture_ = options.positive("rupture");
  for (int n = 0; n < 2; ++n) {
    const char* name = n == 0 ? "top_end" : "bottom_end";
    const auto& names = sleeve_end_names();
    ends_[n] = sleeve_end_of(options.choice(name, names, names[static_cast<int>(ends_[n])]));
  }
  place_supports();
}

void FixMeshSurfaceShell::read_pressure(const Options& options)
{
  if (options.has("pressure"))
    pressure_.set(options.number("pressure"), options.integer("ramp", 1, 1), update->ntimestep);
}

void FixMeshSurfaceShell::place_supports()
{
  std::vector<Support>& supports = model_->support();
  supports.clear();
  add_supports(ends_[0], end_nodes_[0], Vec3::UnitZ(), supports);
  first_bottom_support_ = supports.size();
  add_supports(ends_[1], end_nodes_[1], Vec3::UnitZ(), supports);
}

int FixMeshSurfaceShell::setmask()
{
  using namespace LAMMPS_NS::FixConst;
  return INITIAL_INTEGRATE | POST_FORCE | FINAL_INTEGRATE;
}

void FixMeshSurfaceShell::init()
{
  auto* pair = dynamic_cast<LAMMPS_NS::PairGran*>(force->pair);
  rolling_ = pair && pair->contact_match("rolling_friction", "epsd2");
  try {
    desk_.open(rolling_);
    find_platens(lmp, platen_ids_, platens_);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

HeightWindow FixMeshSurfaceShell::window() const
{
  // Before the first run, and when a platen was taken away, everything counts.
  if (!is_there(lmp, platens_[0]) || !is_there(lmp, platens_[1])) return {};
  return {platens_[1]->height(), platens_[0]->height()};
}

int FixMeshSurfaceShell::modify_param(int narg, char** arg)
{
  try {
    const Options options = keywords.read(narg, arg, 0);
    for (const char* fixed : {"cylinder", "edge", "file", "type", "platens", "modulus", "poisson",
                              "thickness", "bending_thickness", "density", "modulus_axial",
                              "shear_modulus", "tension_only", "mass_scaling", "safety", "every"})
      if (options.has(fixed))
        throw InputError("'" + std::string(fixed) +
                         "' cannot be changed by 'fix_modify', give it on "
                         "the fix line");
    read_changeable(options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  return narg;
}

double FixMeshSurfaceShell::level_inside(double z) const
{
  // Where both ends are whole as they are now; not on their nodes, where a platen stands at the
  // start.
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  for (const int node : end_nodes_[0]) high = std::min(high, model_->position()[node].z());
  for (const int node : end_nodes_[1]) low = std::max(low, model_->position()[node].z());
  const double reserve = 1e-6 * (high - low);
  return low < high ? std::clamp(z, low + reserve, high - reserve) : z;
}

double FixMeshSurfaceShell::compute_vector(int n)
{
  switch (n) {
    case 0:
      return pressure_now();
    case 1:
      return summary().hoop_tension;
    case 2:
      return summary().hoop_tension_max;
    case 3:
      return summary().hoop_strain;
    case 4:
      return summary().hoop_strain_max;
    case 5:
      return axial_force(true);
    case 6:
      return axial_force(false);
    case 7:
      return friction_force();
    case 8:
      return enclosed_volume(window().low, window().high);
    case 9:
      return stored_energy();
    case 10:
      return kinetic_energy();
    case 11:
      return work();
    case 12:
      return damping_loss();
    case 13:
      return mass_factor_;
    default:
      return static_cast<double>(pressure_.steps_left(update->ntimestep));
  }
}

}  // namespace encased_column
