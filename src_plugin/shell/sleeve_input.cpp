// SPDX-License-Identifier: GPL-2.0-only
#include "shell/sleeve_input.h"

#include "files/mesh_file.h"
#include "shell/cloth_input.h"
#include "shell/cylinder_mesh.h"

namespace encased_column {

namespace {

const std::vector<std::string> yes_no{"yes", "no"};

bool is_yes(const Options& options, const std::string& keyword, bool otherwise)
{
  return options.choice(keyword, yes_no, otherwise ? "yes" : "no") == "yes";
}

}  // namespace

const std::vector<Keyword>& sleeve_keywords()
{
  static const std::vector<Keyword> keywords{
      {"cylinder", 3, "m", "a generated sleeve about the z axis: radius, lower and upper end"},
      {"edge", 1, "m", "edge of its facets, larger than zero"},
      {"file", 1, "-",
       "instead of `cylinder`: mesh from a .stl, .vtk or .vtp file, about an axis along z"},
      {"type", 1, "-", "atom type that stands for the material of the sleeve"},
      {"platens", 2, "-", "IDs of the upper and the lower `fix servo/platen`"},
      {"modulus", 1, "Pa",
       "Young's modulus, of hoop if `modulus_axial` is given; with `strip` of unloading"},
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
      {"pressed", 1, "-", "`between` (default): between the platens; or `everywhere`"},
      {"damping", 1, "-", "local damping alpha, 0 to 0.99 (default 0.7)"},
      {"mass_scaling", 1, "-",
       "`yes` (default): nodes as heavy as the step asks for; `no`: true masses"},
      {"safety", 1, "-", "fraction f of the step sqrt(m/k), 0.01 to 1.9 (default 0.8)"},
      {"every", 1, "steps", "how often masses and safety are looked at (default 50)"},
      {"strain_limit", 1, "-",
       "largest principal strain of a facet, with `tension_only` of stretch alone (default 0.5)"},
  };
  static const std::vector<Keyword> all = [] {
    std::vector<Keyword> both = keywords;
    both.insert(both.end(), cloth_keywords().begin(), cloth_keywords().end());
    return both;
  }();
  return all;
}

SurfaceMesh read_sleeve_mesh(const Options& options)
{
  if (options.has("cylinder") == options.has("file"))
    throw InputError("a sleeve takes one of 'cylinder' and 'file', found " +
                     std::string(options.has("file") ? "both" : "neither") +
                     ", write for example 'cylinder 0.05 0 0.2 edge 0.005'");
  if (options.has("file") && options.has("edge"))
    throw InputError(
        "'edge' goes with 'cylinder', found it with 'file', whose facets are given, leave it out");
  if (options.has("file")) return welded(read_mesh_file(options.word("file")));
  const Vec3 size = options.vector("cylinder");
  return cylinder_mesh(TubeShape{size(0), size(1), size(2) - size(1), options.positive("edge")});
}

ShellConstants read_shell_constants(const Options& options)
{
  ShellConstants constants;
  constants.poisson = options.number("poisson");
  constants.thickness = options.positive("thickness");
  constants.density = options.positive("density");
  constants.cloth = read_cloth(options);
  if (!constants.cloth.strip[0].empty() && !options.has("modulus"))
    take_moduli_of_strip(constants);
  else
    constants.modulus_hoop = options.positive("modulus");
  constants.tension_only = is_yes(options, "tension_only", false);
  if (options.has("bending_thickness"))
    constants.bending_thickness = options.not_negative("bending_thickness", 0.0);
  options.assume("bending_thickness", constants.thickness);
  if (options.has("modulus_axial"))
    constants.modulus_axial = options.positive("modulus_axial");
  else if (options.has("shear_modulus") && constants.modulus_axial == 0.0)
    throw InputError(
        "'shear_modulus' goes with 'modulus_axial', found it alone, give both or neither");
  if (options.has("shear_modulus")) constants.shear_modulus = options.positive("shear_modulus");
  return constants;
}

NodalMassRule read_nodal_mass_rule(const Options& options)
{
  return {is_yes(options, "mass_scaling", true), options.between("safety", 0.01, 1.9, 0.8),
          static_cast<int>(options.integer("every", 1, 50))};
}

SleeveControl read_sleeve_control(const Options& options, const SleeveControl& now)
{
  SleeveControl control = now;
  if (options.has("ramp") && !options.has("pressure"))
    throw InputError(
        "'ramp' goes with 'pressure', found it alone, write 'pressure 50e3 ramp 1000'");
  control.rigid = is_yes(options, "rigid", now.rigid);
  control.pressed_everywhere =
      options.choice("pressed", {"between", "everywhere"},
                     now.pressed_everywhere ? "everywhere" : "between") == "everywhere";
  control.damping = options.between("damping", 0.0, 0.99, now.damping);
  control.strain_limit = options.positive("strain_limit", now.strain_limit);
  control.stops_when_torn = options.choice("when_torn", {"stop", "go_on"},
                                           now.stops_when_torn ? "stop" : "go_on") == "stop";
  const auto& names = sleeve_end_names();
  for (int n = 0; n < 2; ++n)
    control.ends[n] = sleeve_end_of(options.choice(n == 0 ? "top_end" : "bottom_end", names,
                                                   names[static_cast<int>(now.ends[n])]));
  return control;
}

void require_changeable(const Options& options)
{
  for (const char* fixed : {"cylinder",       "edge",          "file",
                            "type",           "platens",       "modulus",
                            "poisson",        "thickness",     "bending_thickness",
                            "density",        "modulus_axial", "shear_modulus",
                            "tension_only",   "mass_scaling",  "safety",
                            "every",          "strip",         "strength",
                            "after_strength", "hardening",     "fracture_energy",
                            "seam",           "seam_angle"})
    if (options.has(fixed))
      throw InputError("'" + std::string(fixed) + "' cannot be changed by 'fix_modify', found '" +
                       std::string(fixed) + " " + joined(options.all(fixed).front()) +
                       "', give it on the fix line");
}

}  // namespace encased_column
