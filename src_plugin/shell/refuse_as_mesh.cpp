// SPDX-License-Identifier: GPL-2.0-only
#include "shell/refuse_as_mesh.h"

#include "shell/fix_mesh_surface_shell.h"

namespace encased_column {

namespace {

/// A command of the host that takes meshes, and after which word.
struct MeshTaker {
  const char* style;
  const char* keyword;  ///< none: anywhere behind the first five words
  const char* advice;
};

constexpr const char* with_pictures = "leave it out, 'fix output/sleeve' writes its pictures";
constexpr const char* with_a_mesh = "write the ID of a 'fix mesh/surface'";

constexpr MeshTaker takers[] = {
    {"mesh/stl", nullptr, with_pictures},
    {"stl", nullptr, with_pictures},
    {"mesh/vtk", nullptr, with_pictures},
    {"mesh/gran/VTK", nullptr, with_pictures},
    {"mesh/vtm", nullptr, with_pictures},
    {"contacthistory/mesh", "contacthistory/mesh", with_a_mesh},
    {"contactproperty/atom/wall", "mesh", with_a_mesh},
    {"insert/stream", "insertion_face", with_a_mesh},
    {"massflow/mesh", "mesh", with_a_mesh},
    {"massflow/mesh/sieve", "mesh", with_a_mesh},
    {"move/mesh", "mesh", "leave it out, 'top_end' and 'bottom_end' say how its ends move"},
    {"neighlist/mesh", "neighlist/mesh", with_a_mesh},
};

constexpr int first_of_dump = 5;  ///< dump ID group style N file, then meshes

bool is_sleeve(LAMMPS_NS::LAMMPS* lmp, const char* id)
{
  const int n = lmp->modify->find_fix(id);
  return n >= 0 && dynamic_cast<FixMeshSurfaceShell*>(lmp->modify->fix[n]);
}

bool stands_for_mesh(const MeshTaker& taker, int n, char** arg)
{
  const std::string before = arg[n - 1];
  return taker.keyword ? before == taker.keyword : n >= first_of_dump && before != "region";
}

}  // namespace

std::vector<std::string> fixes_that_take_meshes()
{
  std::vector<std::string> styles;
  for (const MeshTaker& taker : takers)
    if (taker.keyword) styles.emplace_back(taker.style);
  return styles;
}

void refuse_sleeve_as_mesh(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
{
  if (narg < 3) return;
  const std::string style = arg[2];
  for (const MeshTaker& taker : takers)
    for (int n = 3; n < narg && style == taker.style; ++n)
      if (stands_for_mesh(taker, n, arg) && is_sleeve(lmp, arg[n]))
        lmp->error->all(FLERR, ("'" + style + "' takes a mesh of the host, found '" + arg[n] +
                                "', which is a 'fix mesh/surface/shell', " + taker.advice)
                                   .c_str());
}

}  // namespace encased_column
