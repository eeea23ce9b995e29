// SPDX-License-Identifier: GPL-2.0-only
#include "shell/shell_element.h"

#include "core/eigenvalues.h"

#include <algorithm>

namespace encased_column {

namespace {

using Tilts = Eigen::Matrix<double, 6, 1>;

/// Share of a facet's area in its radius of gyration squared, as in Hughes, Cohen and Haroun,
/// Nucl. Eng. Des. 46 (1978) 203-222, who raise the rotary inertia of thin shells to A/8.
constexpr double area_share = 0.125;

Triangle2 in_plane(const FacetVectors& corner, const Vec3& first, const Vec3& second)
{
  Triangle2 plane;
  for (int i = 0; i < 3; ++i) {
    const Vec3 from_first = corner[i] - corner[0];
    plane.col(i) = Vec2(first.dot(from_first), second.dot(from_first));
  }
  return plane;
}

}  // namespace

ShellElement::ShellElement(const FacetVectors& corner, const Vec3& axis,
                           const ShellMaterial& material)
{
  const Vec3 side = corner[1] - corner[0];
  const Vec3 twice_area = side.cross(corner[2] - corner[0]);
  reference_.area = 0.5 * twice_area.norm();
  if (!(reference_.area > 1e-12 * side.squaredNorm()))
    throw InputError("facet of the shell has no area, found " + in_words(reference_.area) +
                     " m2: remove it from the mesh");
  normal_ = twice_area.normalized();
  axial_ = axis - normal_.dot(axis) * normal_;
  if (axial_.norm() < 1e-6 * axis.norm()) axial_ = side;
  axial_.normalize();
  hoop_ = axial_.cross(normal_);
  const Triangle2 plane = in_plane(corner, hoop_, axial_);
  reference_.gradient = area_coordinate_gradients(plane);
  reference_.bending = dkt_tilt_stiffness(plane, material.bending());
}

Triangle2 ShellElement::reference_corners() const
{
  // Each side is the gradient of the area coordinate opposite, turned and scaled by twice the area.
  const auto side = [this](int opposite) -> Vec2 {
    return 2.0 * reference_.area *
           Vec2(reference_.gradient(1, opposite), -reference_.gradient(0, opposite));
  };
  Triangle2 corner;
  corner << Vec2::Zero(), side(2), -side(1);
  return corner;
}

FacetLoads ShellElement::loads(const ShellMaterial& material, const FacetVectors& x,
                               const FacetRotations& r, const FacetMemory& memory) const
{
  const FacetVectors director{r[0] * normal_, r[1] * normal_, r[2] * normal_};
  const auto membrane = [&](const PlaneVector& strain) -> MembraneAnswer {
    return {ShellMaterial::elastic_strain(strain, memory), material.membrane_force(strain, memory)};
  };
  FacetReference reference = reference_;
  reference.bending_left = memory.left();
  return material.bends() ? facet_loads<true>(reference, x, director, membrane)
                          : facet_loads<false>(reference, x, director, membrane);
}

FacetState ShellElement::state(const ShellMaterial& material, const FacetVectors& x,
                               const FacetRotations& r, const FacetMemory& memory) const
{
  const CorotationalFrame frame = frame_at(reference_, x);
  FacetState out;
  out.strain = membrane_strain(frame);
  out.membrane_force = material.membrane_force(out.strain, memory);
  out.membrane_energy =
      reference_.area * ShellMaterial::membrane_energy(
                            ShellMaterial::elastic_strain(out.strain, memory), out.membrane_force);
  out.area_ratio = frame.area_ratio;
  const double mean = 0.5 * (out.strain(0) + out.strain(1));
  const double radius = 0.5 * std::hypot(out.strain(0) - out.strain(1), out.strain(2));
  out.largest_strain = mean + radius;
  out.smallest_strain = mean - radius;

  Tilts tilts;
  Eigen::Matrix<double, 9, 1> plate = Eigen::Matrix<double, 9, 1>::Zero();
  for (int i = 0; i < 3; ++i) {
    const DirectorTilt tilt(frame.to_local(r[i] * normal_));
    tilts(2 * i) = plate(3 * i + 1) = tilt.x;
    tilts(2 * i + 1) = plate(3 * i + 2) = tilt.y;
  }
  out.curvature = dkt_curvature(reference_corners(), Vec3::Constant(1.0 / 3.0)) * plate;
  out.moment = memory.left() * material.bending() * out.curvature;
  out.bending_energy = 0.5 * memory.left() * tilts.dot(reference_.bending * tilts);
  return out;
}

double ShellElement::gyration_square(const ShellMaterial& material) const
{
  const double t = material.constants().thickness;
  return std::max(t * t / 12.0, area_share * reference_.area);
}

std::array<double, 2> ShellElement::tear_widths() const
{
  const auto chord = [this](int direction) {
    return 1.0 / reference_.gradient.row(direction).cwiseAbs().maxCoeff();
  };
  return {chord(0), chord(1)};
}

StiffnessBound ShellElement::stiffness_bound(const ShellMaterial& material, const FacetVectors& x,
                                             const FacetMemory& memory) const
{
  const CorotationalFrame frame = frame_at(reference_, x);
  const PlaneVector n = material.membrane_force(membrane_strain(frame), memory);
  const Mat3& d = material.membrane();

  // Largest eigenvalue of sum_a grad_a grad_a^T.
  const Mat2 spread = reference_.gradient * reference_.gradient.transpose();
  const double spread_bound =
      0.5 * spread.trace() + std::hypot(0.5 * (spread(0, 0) - spread(1, 1)), spread(0, 1));
  // In its plane: the law on symmetric parts of the gradient (shear counts twice: two components
  // make one angle), the tension on the antisymmetric one.
  const double direct = 0.5 * (d(0, 0) + d(1, 1)) + std::hypot(0.5 * (d(0, 0) - d(1, 1)), d(0, 1));
  const double turning = (n(0) + n(1)) / frame.trace();
  const double in_plane =
      reference_.area * spread_bound * std::max({direct, 2.0 * d(2, 2), turning});

  // Across it: pre-tension U^-1 N (largest principal value, bounded by the sum of the parts), and
  // bending through the tilts and the turn of the facet.
  const double inverse = 1.0 / frame.area_ratio;
  const double tension = std::max(0.0, 0.5 * (n(0) + n(1)) + std::hypot(0.5 * (n(0) - n(1)), n(2)));
  const double smallest_stretch =
      0.5 * frame.trace() - std::hypot(0.5 * (frame.u11 - frame.u22), frame.u12);
  double across = reference_.area * spread_bound * tension / std::max(smallest_stretch, 1e-3);

  const double square = gyration_square(material);
  double bending = 0.0;
  if (material.bends()) {
    // Columns: rise of the three nodes, then their tilts in units of the gyration radius.
    Eigen::Matrix<double, 6, 9> to_tilt = Eigen::Matrix<double, 6, 9>::Zero();
    const double length = std::sqrt(square);
    for (int a = 0; a < 3; ++a) {
      const double g1 = reference_.gradient(0, a), g2 = reference_.gradient(1, a);
      const double spin_x = inverse * (frame.u11 * g2 - frame.u12 * g1);
      const double spin_y = inverse * (frame.u12 * g2 - frame.u22 * g1);
      for (int i = 0; i < 3; ++i) {
        to_tilt(2 * i, a) = -spin_x;
        to_tilt(2 * i + 1, a) = -spin_y;
      }
      to_tilt(2 * a, 3 + 2 * a) = 1.0 / length;
      to_tilt(2 * a + 1, 4 + 2 * a) = 1.0 / length;
    }
    const PlateStiffness whole = to_tilt.transpose() * reference_.bending * to_tilt;
    bending = symmetric_eigenvalues(whole)(8);
  }
  return {std::max(in_plane, across + bending), bending * square};
}

}  // namespace encased_column
