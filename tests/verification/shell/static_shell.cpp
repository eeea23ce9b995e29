// SPDX-License-Identifier: GPL-2.0-only
#include "static_shell.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace encased_column {

Relaxation relax(ShellModel& model, const AddLoads& add_loads, double tolerance, long most_steps,
                 double alpha)
{
  const double factor = 1.6;
  std::vector<StiffnessBound> bound(model.nodes(), {0.0, 0.0});
  model.add_stiffness(0, model.facets(), bound);
  std::vector<double> mass(model.nodes()), inertia(model.nodes());
  for (int i = 0; i < model.nodes(); ++i) {
    mass[i] = bound[i].translation / (factor * factor);
    inertia[i] = std::max(bound[i].rotation, 1e-30) / (factor * factor);
  }
  model.set_masses(mass, inertia);

  model.clear_loads();
  add_loads(model);
  double scale = 0.0;
  for (const Vec3& load : model.load()) scale = std::max(scale, load.norm());

  Relaxation out{0, 0.0};
  for (out.steps = 1; out.steps <= most_steps; ++out.steps) {
    model.clear_loads();
    model.add_internal_loads(0, model.facets());
    add_loads(model);
    if (out.steps % 100 == 0) {
      std::vector<Vec3> rest(model.load().begin(), model.load().begin() + model.nodes());
      for (const Support& support : model.support())
        rest[support.node] -= support.held * rest[support.node];
      out.unbalanced = 0.0;
      for (const Vec3& force : rest)
        out.unbalanced = std::max(out.unbalanced, force.norm() / scale);
      if (out.unbalanced < tolerance) return out;
    }
    model.advance(1.0, alpha);
  }
  return out;
}

Eigen::VectorXd direct_solution(const ShellModel& model)
{
  using Entry = Eigen::Triplet<double>;
  const int freedoms = 6 * model.nodes();
  const auto number = [&](int facet, int corner, bool turn) {
    return 6 * model.facet()[facet][corner] + (turn ? 3 : 0);
  };
  std::vector<Entry> entries;
  for (int f = 0; f < model.facets(); ++f) {
    const ShellElement& element = model.element()[f];
    const double step = 1e-6 * std::sqrt(element.area());
    for (int j = 0; j < 18; ++j) {
      const int corner = (j % 9) / 3, axis = j % 3;
      const auto loads = [&](double h) {
        FacetVectors x = model.corners(f);
        FacetRotations r = model.corner_rotations(f);
        if (j < 9)
          x[corner](axis) += h;
        else
          r[corner] = rotation_from_vector(h * Vec3::Unit(axis)).toRotationMatrix() * r[corner];
        return element.loads(model.material(), x, r);
      };
      const double h = j < 9 ? step : 1e-6;
      const FacetLoads up = loads(h), down = loads(-h);
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
          const int column = number(f, corner, j >= 9) + axis;
          entries.emplace_back(number(f, i, false) + k, column,
                               -(up.force[i](k) - down.force[i](k)) / (2.0 * h));
          entries.emplace_back(number(f, i, true) + k, column,
                               -(up.moment[i](k) - down.moment[i](k)) / (2.0 * h));
        }
    }
  }
  // The problems solved here hold whole coordinates, so a support strikes out its rows and columns.
  std::vector<char> fixed(freedoms, 0);
  for (const Support& support : model.support())
    for (int k = 0; k < 3; ++k) {
      if (support.held(k, k) > 0.5) fixed[6 * support.node + k] = 1;
      if (support.held_rotation(k, k) > 0.5) fixed[6 * support.node + 3 + k] = 1;
    }
  double largest = 0.0;
  for (const Entry& e : entries) largest = std::max(largest, std::abs(e.value()));
  std::vector<Entry> kept;
  for (const Entry& e : entries)
    if (!fixed[e.row()] && !fixed[e.col()]) kept.push_back(e);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(freedoms);
  for (int i = 0; i < freedoms; ++i) {
    if (fixed[i])
      kept.emplace_back(i, i, largest);
    else
      load(i) = model.load()[(i % 6 < 3 ? 0 : model.nodes()) + i / 6](i % 3);
  }
  Eigen::SparseMatrix<double> stiffness(freedoms, freedoms);
  stiffness.setFromTriplets(kept.begin(), kept.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(stiffness);
  return solver.solve(load);
}

SurfaceMesh cylinder_panel(double radius, double arc, double length, int n)
{
  SurfaceMesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double angle = arc * i / n;
      mesh.node.emplace_back(radius * std::sin(angle), length * j / n, radius * std::cos(angle));
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = i + (n + 1) * j, b = a + 1, c = b + n + 1, d = a + n + 1;
      mesh.facet.push_back({a, b, c});
      mesh.facet.push_back({a, c, d});
    }
  return mesh;
}

std::vector<double> nodal_areas(const ShellModel& model)
{
  std::vector<double> area(model.nodes(), 0.0);
  for (int f = 0; f < model.facets(); ++f)
    for (const int node : model.facet()[f]) area[node] += model.element()[f].area() / 3.0;
  return area;
}

}  // namespace encased_column
