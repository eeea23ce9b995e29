// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/facet_loads.h"
#include "shell/shell_material.h"

namespace encased_column {

/// What is written for the user; material axes (hoop, axial), forces per reference length.
struct FacetState {
  PlaneVector strain;          ///< engineering (e_hoop, e_axial, shear angle) [-]
  PlaneVector membrane_force;  ///< (N_hoop, N_axial, N_shear) [N/m]; the first is the hoop tension
  PlaneVector curvature;       ///< at the centroid (hoop, axial, 2 twist) [1/m]
  PlaneVector moment;          ///< t_b^3 D / 12 times the curvature [N m/m]
  double largest_strain;       ///< principal [-]
  double smallest_strain;      ///< principal [-]
  double area_ratio;           ///< current over reference area [-]
  double membrane_energy;      ///< stored [J]
  double bending_energy;       ///< [J]
};

/// Upper bounds of a facet's stiffness: its stiffness matrix is smaller, as a quadratic form, than
/// the diagonal of these, so sums over the facets of a node bound the whole sleeve.
struct StiffnessBound {
  double translation;  ///< per node [N/m]
  double rotation;     ///< per node [N m/rad]
};

/// A corotational three-node shell facet: CST membrane, DKT bending. Formulation: theory.md.
class ShellElement {
 public:
  /// `corner` are the reference positions [m]; the material's axial direction is `axis` projected
  /// on the facet (a facet at right angles to it takes its first side), hoop is axial x normal.
  /// Throws InputError for a facet without area.
  ShellElement(const FacetVectors& corner, const Vec3& axis, const ShellMaterial& material);

  double area() const { return reference_.area; }
  const FacetReference& reference() const { return reference_; }
  const Vec3& normal() const { return normal_; }
  const Vec3& hoop_direction() const { return hoop_; }
  const Vec3& axial_direction() const { return axial_; }

  /// Forces, moments and energy at node positions `x` [m] and rotations `r` from the reference:
  /// minus the exact gradient of the energy stored.
  FacetLoads loads(const ShellMaterial& material, const FacetVectors& x, const FacetRotations& r,
                   const FacetMemory& memory = {}) const;

  FacetState state(const ShellMaterial& material, const FacetVectors& x, const FacetRotations& r,
                   const FacetMemory& memory = {}) const;

  /// Bounds at the current positions, pre-tension included; of the whole cloth, damage only lowers
  /// its stiffness.
  StiffnessBound stiffness_bound(const ShellMaterial& material, const FacetVectors& x,
                                 const FacetMemory& memory = {}) const;

  /// Widths [m] of the bands (hoop, axial) in which the facet tears: its longest chords along them,
  /// so that facets side by side across a direction take the fracture energy of their width.
  /// Source: Oliver, Int. J. Num. Meth. Eng. 28 (1989) 461-474, for triangles of constant strain.
  std::array<double, 2> tear_widths() const;

  /// Square of the length [m^2] that relates rotational to translational inertia: the facet's own
  /// rotatory inertia per mass (t^2/12), but at least a share of its area, so that the rotations
  /// never set the step.
  double gyration_square(const ShellMaterial& material) const;

 private:
  Triangle2 reference_corners() const;  ///< material axes, the first at the origin [m]

  Vec3 normal_, hoop_, axial_;
  FacetReference reference_;
};

}  // namespace encased_column
