// SPDX-License-Identifier: GPL-2.0-only
#include "shell/fix_wall_of_sleeves.h"

#include "core/input_error.h"
#include "host/granular_host.h"
#include "shell/fix_mesh_surface_shell.h"

#include <algorithm>
#include <vector>

namespace encased_column {

namespace {

bool is_sleeve(LAMMPS_NS::LAMMPS* lmp, const std::string& id)
{
  const int n = lmp->modify->find_fix(id.c_str());
  return n >= 0 && dynamic_cast<FixMeshSurfaceShell*>(lmp->modify->fix[n]);
}

void check_model(LAMMPS_NS::LAMMPS* lmp, const std::string& model)
{
  auto* pair = dynamic_cast<LAMMPS_NS::PairGran*>(lmp->force->pair);
  const bool rolling = pair && pair->contact_match("rolling_friction", "epsd2");
  const std::string pairs =
      std::string("linear tangential history") + (rolling ? " rolling_friction epsd2" : "");
  if (model != pairs)
    lmp->error->all(FLERR, ("'model' must be that of the pair style for a wall of sleeves, '" +
                            pairs + "', found '" + model + "', write 'model " + pairs + "'")
                               .c_str());
}

}  // namespace

LAMMPS_NS::Fix* make_wall(FixCreator host, LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
{
  std::vector<std::string> words(arg, arg + narg);
  const auto model = std::find(words.begin(), words.end(), "model");
  const auto mesh = std::find(model, words.end(), "mesh");
  const auto meshes = std::find(mesh, words.end(), "meshes");
  const auto first_sleeve =
      std::find_if(meshes, words.end(), [&](const std::string& id) { return is_sleeve(lmp, id); });
  if (first_sleeve == words.end()) return host(lmp, narg, arg);
  if (meshes - mesh != 3 || *(mesh + 1) != "n_meshes")
    lmp->error->all(FLERR,
                    ("a wall with sleeves is written 'mesh n_meshes N meshes ID ...', found '" +
                     joined({mesh, words.end()}) + "', write for example 'mesh n_meshes 1 meshes " +
                     *first_sleeve + "'")
                        .c_str());
  check_model(lmp, joined({model + 1, mesh}));

  words.erase(std::remove_if(meshes + 1, words.end(),
                             [&](const std::string& id) { return is_sleeve(lmp, id); }),
              words.end());
  const auto left = words.end() - meshes - 1;
  *(mesh + 2) = std::to_string(left);
  // What stands for sleeves alone is not called wall/gran: the host casts what is to its own wall.
  if (left == 0) words[2] = "wall/sleeve";
  std::vector<char*> changed;
  for (std::string& word : words) changed.push_back(word.data());
  const int count = static_cast<int>(changed.size());
  if (left == 0) return new FixWallOfSleeves(lmp, count, changed.data());
  return host(lmp, count, changed.data());
}

}  // namespace encased_column
