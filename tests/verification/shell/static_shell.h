// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/shell_model.h"

#include <functional>

namespace encased_column {

/// Adds the loads of a problem to the cleared and internally loaded model.
using AddLoads = std::function<void(ShellModel&)>;

/// How a search for equilibrium ended.
struct Relaxation {
  long steps;
  double unbalanced;  ///< largest unbalanced force over the largest applied one
};

/// Runs the product's integrator with local damping to the static state: every node gets the mass
/// for which a unit step is just stable (factor 1.6 of 2), so all of them settle equally fast; ends
/// when the largest unbalanced force or moment stays below `tolerance` of the largest force.
Relaxation relax(ShellModel& model, const AddLoads& add_loads, double tolerance, long most_steps,
                 double alpha = 0.7);

/// Displacements and small rotations (6 per node) under the model's present load() by a direct
/// solve with the tangent of the internal loads at the reference, taken by differences: a second
/// way to the static state that shares neither the integrator nor the stiffness bounds with
/// relax().
Eigen::VectorXd direct_solution(const ShellModel& model);

/// Part of a cylinder about y: nodes at (R sin a, y, R cos a) for a from 0 to `arc` and y from 0 to
/// `length`, `n` by `n` squares each cut in two. Node (i, j) is i + (n + 1) j, i along the arc.
SurfaceMesh cylinder_panel(double radius, double arc, double length, int n);

/// Sum of one third of the facets' areas at each node [m^2].
std::vector<double> nodal_areas(const ShellModel& model);

}  // namespace encased_column
