#pragma once

#include "core/vec3.h"
#include "host/granular_host.h"

#include "mesh_mover.h"

namespace encased_column {

/// Access to the nodes of a mesh and to the velocities `fix wall/gran` reads for the contact point.
/// Both are per triangle and node, for owned triangles and ghosts.
class WallMover : public LAMMPS_NS::MeshMover {
 public:
  WallMover(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::FixMeshSurface* fix)
      : LAMMPS_NS::MeshMover(lmp, fix->mesh(), nullptr), mesh_fix_(fix)
  {
    isFirst_ = mesh_->registerMove(true, true, true);
    if (!mesh_->prop().getElementProperty<NodeVectors>("v"))
      mesh_->prop().addElementProperty<NodeVectors>("v", "comm_exchange_borders", "frame_invariant",
                                                    "restart_no");
    zero_velocities();
  }

  void post_create() override {}
  void pre_delete() override { mesh_->unregisterMove(true, true, true); }
  void initial_integrate(double, double, double) override {}

  int owned() const { return mesh_->sizeLocal(); }

  Vec3 node(int triangle, int corner) { return Vec3(get_nodes()[triangle][corner]); }

  /// Moves every node x by `displacement(x)` [m] and gives it `velocity(x)` [m/s].
  template <typename Displacement, typename Velocity>
  void move_nodes(Displacement displacement, Velocity velocity)
  {
    double*** nodes = get_nodes();
    double*** velocities = get_v();
    const int n = mesh_->size();
    for (int triangle = 0; triangle < n; ++triangle)
      for (int corner = 0; corner < 3; ++corner) {
        auto x = as_vec3(nodes[triangle][corner]);
        as_vec3(velocities[triangle][corner]) = velocity(Vec3(x));
        x += displacement(Vec3(x));
      }
    mesh_fix_->triMesh()->updateCenterRbound(0, n);
    mesh_fix_->triMesh()->updateGlobalBoundingBox();
  }

  void zero_velocities()
  {
    double*** velocities = get_v();
    for (int triangle = 0; triangle < mesh_->size(); ++triangle)
      for (int corner = 0; corner < 3; ++corner) as_vec3(velocities[triangle][corner]).setZero();
  }

 private:
  using NodeVectors = LAMMPS_NS::MultiVectorContainer<double, 3, 3>;
  LAMMPS_NS::FixMeshSurface* mesh_fix_;
};

}  // namespace encased_column
