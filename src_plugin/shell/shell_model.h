// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/facet_batches.h"
#include "shell/rotation.h"
#include "shell/shell_element.h"
#include "shell/shell_support.h"
#include "shell/surface_mesh.h"

#include <vector>

namespace encased_column {

/// What a step did to the energy of a sleeve [J].
struct StepWork {
  double external = 0.0;  ///< work of the loads in external()
  double supports = 0.0;  ///< work of supports that move, or bring a node to rest
  double damping = 0.0;   ///< taken out by the local damping
};

/// A sleeve: nodes, facets, and the explicit integrator that moves them.
///
/// One step is: clear_loads() or load_external(); add_internal_loads() over a range of facets and
/// contacts onto load(); where ranks share the facets, one sum of load() over them; advance().
/// Every node is known everywhere, so advance() gives the same on every rank. No step allocates
/// memory.
class ShellModel {
 public:
  /// `axis` is the axial direction of the material. Throws InputError for a facet without area.
  ShellModel(const SurfaceMesh& mesh, const ShellConstants& constants, const Vec3& axis);

  int nodes() const { return static_cast<int>(position_.size()); }
  int facets() const { return static_cast<int>(facet_.size()); }
  const ShellMaterial& material() const { return material_; }
  const std::vector<Facet>& facet() const { return facet_; }
  const std::vector<ShellElement>& element() const { return element_; }
  const std::vector<Vec3>& reference() const { return reference_; }
  const std::vector<Vec3>& position() const { return position_; }
  /// Never less than the way of any node between two calls [m]; grows.
  double travel() const { return travel_; }
  const std::vector<Quaternion>& rotation() const { return rotation_; }
  /// Half a step behind the positions, as are the angular velocities.
  const std::vector<Vec3>& velocity() const { return velocity_; }
  const std::vector<Vec3>& angular_velocity() const { return angular_velocity_; }
  const std::vector<double>& mass() const { return mass_; }        ///< scaled [kg]
  const std::vector<double>& inertia() const { return inertia_; }  ///< scaled [kg m^2]
  const std::vector<double>& true_mass() const { return true_mass_; }

  /// Forces of all nodes [N], then their moments [N m]: one stretch of memory for one sum over
  /// ranks.
  std::vector<Vec3>& load() { return load_; }
  const std::vector<Vec3>& load() const { return load_; }
  Vec3& force(int node) { return load_[node]; }
  Vec3& moment(int node) { return load_[nodes() + node]; }
  const Vec3& force(int node) const { return load_[node]; }
  const Vec3& moment(int node) const { return load_[nodes() + node]; }

  /// Part of the loads [N], one vector a node, of which advance() tells the work; load() has it
  /// from load_external() or from the caller. Where ranks share the facets, each holds its part and
  /// gets its part of the work.
  std::vector<Vec3>& external() { return external_; }

  std::vector<Support>& support() { return support_; }
  const std::vector<Support>& support() const { return support_; }

  /// Places the sleeve, for a start that is not the reference and for a restart.
  void set_state(const std::vector<Vec3>& position, const std::vector<Quaternion>& rotation,
                 const std::vector<Vec3>& velocity, const std::vector<Vec3>& angular_velocity);
  void set_masses(const std::vector<double>& mass, const std::vector<double>& inertia);

  void clear_loads();
  /// Puts external() in place of all loads: less to write than to clear them and to add it.
  void load_external();
  /// Adds the internal forces and moments of facets [first, last); returns their energy [J]. Before
  /// that a cloth yields and tears by the loads of the call before, unless `at_set_up`.
  double add_internal_loads(int first, int last, bool at_set_up = false);
  /// What its facets remember and have taken out; empty unless the sleeve is a cloth.
  ClothFacets& cloth() { return batches_.cloth(); }
  const ClothFacets& cloth() const { return batches_.cloth(); }
  /// Of the strength of a direction, less than 1 on a seam [-].
  double strength_share(int direction, int facet) const
  {
    return cloth().empty() ? 1.0 : cloth().strength_share(direction, facet);
  }
  FacetMemory memory(int facet) const
  {
    return cloth().empty() ? FacetMemory() : cloth().memory(facet);
  }
  /// One step of central differences: local damping -alpha |F| sign(v) per component of force and
  /// moment, supports, then motion.
  StepWork advance(double dt, double alpha);
  /// Finds what the supports bear of the loads as they stand; advance() does so too.
  void find_reactions();

  FacetVectors corners(int facet) const;
  FacetRotations corner_rotations(int facet) const;
  FacetState facet_state(int facet) const;

  /// Adds to `bound` (sized nodes()) the stiffness bounds of facets [first, last) where they are
  /// now.
  void add_stiffness(int first, int last, std::vector<StiffnessBound>& bound) const;
  /// factor sqrt(m / k), smallest over nodes, translations and rotations [s]. Stable below factor
  /// 2, because the sum of the bounds is never below the largest eigenvalue.
  double stable_step(const std::vector<StiffnessBound>& bound, double factor) const;
  /// Raises masses and inertias where `dt` [s] asks for it, from the true ones if
  /// `from_true_masses`, else from what they are, as change_inertia() does; returns the energy [J]
  /// that this takes out.
  double scale_masses(const std::vector<StiffnessBound>& bound, double dt, double factor,
                      bool from_true_masses = false);
  /// Total mass over the true one [-].
  double mass_factor() const;

  /// Translational and rotational energy at the half step of the velocities [J].
  double kinetic_energy() const;

 private:
  double damping_work(int i, double dt, double alpha, const Mat3& free,
                      const Mat3& free_rotation) const;
  double support_work(const Support& support, double dt) const;

  ShellMaterial material_;
  std::vector<Facet> facet_;
  std::vector<ShellElement> element_;
  FacetBatches batches_;
  std::vector<Vec3> reference_, position_, velocity_, angular_velocity_, load_, external_;
  std::vector<Vec3> velocity_before_, spin_before_;
  std::vector<Quaternion> rotation_;
  std::vector<double> true_mass_, true_inertia_, mass_, inertia_;
  std::vector<Support> support_;
  double travel_ = 0.0;
};

}  // namespace encased_column
