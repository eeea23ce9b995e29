#include "shell/fix_wall_of_sleeves.h"

#include "core/input_error.h"
#include "host/granular_host.h"
#include "shell/fix_mesh_surface_shell.h"

#include <algorithm>
#include <vector>

namespace encased_column {

namespace {

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

bool is_sleeve(LAMMPS_NS::LAMMPS* lmp, const std::string& id)
{
  const int n = lmp->modify->find_fix(id.c_str());
  return n >= 0 && dynamic_cast<FixMeshSurfaceShell*>(lmp->modify->fix[n]);
}

}  // namespace

FixWallOfSleeves::FixWallOfSleeves(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg,
                                   const std::string& model)
    : Fix(lmp, narg, arg),
      model_(model)
{
}

void FixWallOfSleeves::init()
{
  auto* pair = dynamic_cast<LAMMPS_NS::PairGran*>(force->pair);
  const bool rolling = pair && pair->contact_match("rolling_friction", "epsd2");
  const std::string pairs =
      std::string("linear tangential history") + (rolling ? " rolling_friction epsd2" : "");
  if (model_ != pairs)
    error->fix_error(FLERR, this,
                     ("'model' must be that of the pair style for a wall of sleeves, '" + pairs +
                      "', found '" + model_ + "'")
                         .c_str());
}

LAMMPS_NS::Fix* make_wall(FixCreator host, LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
{
  const std::vector<std::string> words(arg, arg + narg);
  const auto model = std::find(words.begin(), words.end(), "model");
  const auto mesh = std::find(model, words.end(), "mesh");
  const auto meshes = std::find(mesh, words.end(), "meshes");
  if (meshes == words.end()) return host(lmp, narg, arg);
  const std::vector<std::string> ids(meshes + 1, words.end());
  const auto sleeves =
      std::count_if(ids.begin(), ids.end(), [&](const auto& id) { return is_sleeve(lmp, id); });
  if (sleeves == 0) return host(lmp, narg, arg);
  if (sleeves != static_cast<long>(ids.size()) || meshes - mesh != 3)
    lmp->error->all(FLERR, ("'meshes' of a fix wall/gran takes sleeves alone and last, found '" +
                            joined({mesh, words.end()}) +
                            "', write one fix wall/gran for sleeves and one for the rest")
                               .c_str());
  // Not called wall/gran: the host casts what is to its own wall.
  std::string style = "wall/sleeve";
  std::vector<char*> changed(arg, arg + narg);
  changed[2] = style.data();
  return new FixWallOfSleeves(lmp, narg, changed.data(), joined({model + 1, mesh}));
}

}  // namespace encased_column
