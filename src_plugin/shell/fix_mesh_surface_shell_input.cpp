// What the deck says of the sleeve.
#include "shell/fix_mesh_surface_shell.h"

#include "files/mesh_file.h"
#include "shell/cylinder_mesh.h"
#include "shell/enclosed_volume.h"

#include <algorithm>

namespace encased_column {

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
    throw InputError(
        "'edge' goes with 'cylinder', found it with 'file', whose facets are given, leave it out");
  SurfaceMesh mesh;
  if (options.has("file")) {
    mesh = welded(read_mesh_file(options.word("file")));
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

void FixMeshSurfaceShell::read_weighing(const Options& options)
{
  scale_masses_ = options.choice("mass_scaling", yes_no, "yes") == "yes";
  safety_ = options.between("safety", 0.01, 1.9, 0.8);
  every_ = static_cast<int>(options.integer("every", 1, 50));
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

int FixMeshSurfaceShell::modify_param(int narg, char** arg)
{
  try {
    const Options options = keywords.read(narg, arg, 0);
    for (const char* fixed : {"cylinder", "edge", "file", "type", "platens", "modulus", "poisson",
                              "thickness", "bending_thickness", "density", "modulus_axial",
                              "shear_modulus", "tension_only", "mass_scaling", "safety", "every"})
      if (options.has(fixed))
        throw InputError("'" + std::string(fixed) + "' cannot be changed by 'fix_modify', found '" +
                         std::string(fixed) + " " + joined(options.all(fixed).front()) +
                         "', give it on the fix line");
    read_changeable(options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  return narg;
}

}  // namespace encased_column
