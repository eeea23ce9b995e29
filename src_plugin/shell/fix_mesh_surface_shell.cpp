#include "shell/fix_mesh_surface_shell.h"

#include "host/box_of_run.h"
#include "host/find_fix.h"
#include "servo/find_platens.h"

#include "pair_gran.h"

#include <cstring>

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
    read_weighing(options);
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
    require_open_box(lmp, "mesh/surface/shell", "xy");
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

}  // namespace encased_column
