// SPDX-License-Identifier: GPL-2.0-only
#include "shell/shell_model.h"

#include "dynamics/local_damping.h"
#include "dynamics/mass_scaling.h"
#include "shell/node_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace encased_column {

namespace {

Vec3 damped(const Vec3& load, const Vec3& velocity, double alpha)
{
  return load.binaryExpr(
      velocity, [alpha](double f, double v) { return encased_column::damped(f, v, alpha); });
}

}  // namespace

ShellModel::ShellModel(const SurfaceMesh& mesh, const ShellConstants& constants, const Vec3& axis)
    : material_(constants),
      facet_(mesh.facet),
      reference_(mesh.node),
      position_(mesh.node)
{
  const std::size_t n = mesh.node.size();
  velocity_.assign(n, Vec3::Zero());
  angular_velocity_.assign(n, Vec3::Zero());
  load_.assign(2 * n, Vec3::Zero());
  external_ = velocity_before_ = spin_before_ = velocity_;
  rotation_.assign(n, Quaternion::Identity());
  mass_.assign(n, 0.0);
  inertia_.assign(n, 0.0);
  element_.reserve(facet_.size());
  for (int f = 0; f < facets(); ++f) {
    element_.emplace_back(corners(f), axis, material_);
    const ShellElement& element = element_.back();
    const double share = constants.density * constants.thickness * element.area() / 3.0;
    for (const int node : facet_[f]) {
      mass_[node] += share;
      inertia_[node] += share * element.gyration_square(material_);
    }
  }
  batches_ = FacetBatches(facet_, element_, material_);
  true_mass_ = mass_;
  true_inertia_ = inertia_;
}

void ShellModel::set_state(const std::vector<Vec3>& position,
                           const std::vector<Quaternion>& rotation,
                           const std::vector<Vec3>& velocity,
                           const std::vector<Vec3>& angular_velocity)
{
  double jump = 0.0;
  for (int i = 0; i < nodes(); ++i) jump = std::max(jump, (position[i] - position_[i]).norm());
  travel_ += jump;
  position_ = position;
  rotation_ = rotation;
  velocity_ = velocity;
  angular_velocity_ = angular_velocity;
}

void ShellModel::set_masses(const std::vector<double>& mass, const std::vector<double>& inertia)
{
  mass_ = mass;
  inertia_ = inertia;
}

void ShellModel::clear_loads()
{
  std::fill(load_.begin(), load_.end(), Vec3::Zero());
  std::fill(external_.begin(), external_.end(), Vec3::Zero());
}

void ShellModel::load_external()
{
  std::copy(external_.begin(), external_.end(), load_.begin());
  std::fill(load_.begin() + nodes(), load_.end(), Vec3::Zero());
}

FacetVectors ShellModel::corners(int facet) const
{
  const Facet& node = facet_[facet];
  return {position_[node[0]], position_[node[1]], position_[node[2]]};
}

FacetRotations ShellModel::corner_rotations(int facet) const
{
  const Facet& node = facet_[facet];
  return {rotation_[node[0]].toRotationMatrix(), rotation_[node[1]].toRotationMatrix(),
          rotation_[node[2]].toRotationMatrix()};
}

FacetState ShellModel::facet_state(int facet) const
{
  return element_[facet].state(material_, corners(facet), corner_rotations(facet), memory(facet));
}

double ShellModel::add_internal_loads(int first, int last, bool at_set_up)
{
  if (material_.bends() || material_.is_cloth())
    return batches_.add_loads(first, last, at_set_up, position_.data(),
                              rotation_.front().coeffs().data(), load_.data(),
                              load_.data() + nodes());
  double energy = 0.0;
  for (int f = first; f < last; ++f) {
    const FacetLoads loads = element_[f].loads(material_, corners(f), corner_rotations(f));
    for (int i = 0; i < 3; ++i) {
      force(facet_[f][i]) += loads.force[i];
      moment(facet_[f][i]) += loads.moment[i];
    }
    energy += loads.energy;
  }
  return energy;
}

StepWork ShellModel::advance(double dt, double alpha)
{
  StepWork work;
  velocity_before_ = velocity_;
  spin_before_ = angular_velocity_;
  work.damping =
      kick_nodes(force(0).data(), mass_.data(), nodes(), alpha, dt, velocity_.front().data()) +
      kick_nodes(moment(0).data(), inertia_.data(), nodes(), alpha, dt,
                 angular_velocity_.front().data());
  for (Support& support : support_) {
    const int i = support.node;
    work.damping -= damping_work(i, dt, alpha, Mat3::Identity(), Mat3::Identity());
    velocity_[i] -= support.held * (velocity_[i] - support.velocity);
    angular_velocity_[i] -=
        support.held_rotation * (angular_velocity_[i] - support.angular_velocity);
    work.damping += damping_work(i, dt, alpha, Mat3::Identity() - support.held,
                                 Mat3::Identity() - support.held_rotation);
    support.force = -support.held * force(i);
    support.moment = -support.held_rotation * moment(i);
    work.supports += support_work(support, dt);
  }
  double fastest = 0.0;
  for (int i = 0; i < nodes(); ++i) {
    fastest = std::max(fastest, velocity_[i].squaredNorm());
    work.external += 0.5 * dt * external_[i].dot(velocity_before_[i] + velocity_[i]);
    position_[i] += dt * velocity_[i];
  }
  for (int first = 0; first < nodes(); first += nodes_in_batch) {
    const int last = std::min(first + nodes_in_batch, nodes());
    if (turn_nodes(angular_velocity_[first].data(), last - first, dt,
                   rotation_[first].coeffs().data()))
      continue;
    for (int i = first; i < last; ++i)
      rotation_[i] = turned(rotation_[i], angular_velocity_[i], dt);
  }
  travel_ += dt * std::sqrt(fastest);
  return work;
}

void ShellModel::find_reactions()
{
  for (Support& support : support_) {
    support.force = -support.held * force(support.node);
    support.moment = -support.held_rotation * moment(support.node);
  }
}

// Of the damping force only what `free` lets through does work: the rest the support takes up.
double ShellModel::damping_work(int i, double dt, double alpha, const Mat3& free,
                                const Mat3& free_rotation) const
{
  const Vec3 brake = free * (force(i) - damped(force(i), velocity_before_[i], alpha));
  const Vec3 brake_spin = free_rotation * (moment(i) - damped(moment(i), spin_before_[i], alpha));
  return 0.5 * dt *
         (brake.dot(velocity_before_[i] + velocity_[i]) +
          brake_spin.dot(spin_before_[i] + angular_velocity_[i]));
}

// The support bears the loads and makes the node keep its velocity: where that changes, it gives
// the node its kinetic energy too. Loads count with the mean velocity, as in all works of a step.
double ShellModel::support_work(const Support& support, double dt) const
{
  const int i = support.node;
  const Vec3 before = support.held * velocity_before_[i], now = support.held * velocity_[i];
  const Vec3 spin_before = support.held_rotation * spin_before_[i],
             spin = support.held_rotation * angular_velocity_[i];
  return 0.5 * (mass_[i] * (now.squaredNorm() - before.squaredNorm()) +
                inertia_[i] * (spin.squaredNorm() - spin_before.squaredNorm()) +
                dt * (support.force.dot(before + now) + support.moment.dot(spin_before + spin)));
}

void ShellModel::add_stiffness(int first, int last, std::vector<StiffnessBound>& bound) const
{
  for (int f = first; f < last; ++f) {
    const StiffnessBound facet = element_[f].stiffness_bound(material_, corners(f), memory(f));
    for (const int node : facet_[f]) {
      bound[node].translation += facet.translation;
      bound[node].rotation += facet.rotation;
    }
  }
}

double ShellModel::stable_step(const std::vector<StiffnessBound>& bound, double factor) const
{
  double square = std::numeric_limits<double>::infinity();
  for (int i = 0; i < nodes(); ++i) {
    square = std::min(square, mass_[i] / bound[i].translation);
    if (bound[i].rotation > 0.0) square = std::min(square, inertia_[i] / bound[i].rotation);
  }
  return factor * std::sqrt(square);
}

double ShellModel::scale_masses(const std::vector<StiffnessBound>& bound, double dt, double factor,
                                bool from_true_masses)
{
  const double need = dt * dt / (factor * factor);
  double taken = 0.0;
  for (int i = 0; i < nodes(); ++i) {
    taken += change_inertia(
        mass_[i],
        std::max(from_true_masses ? true_mass_[i] : mass_[i], need * bound[i].translation),
        velocity_[i]);
    taken += change_inertia(
        inertia_[i],
        std::max(from_true_masses ? true_inertia_[i] : inertia_[i], need * bound[i].rotation),
        angular_velocity_[i]);
  }
  return taken;
}

double ShellModel::mass_factor() const
{
  return std::accumulate(mass_.begin(), mass_.end(), 0.0) /
         std::accumulate(true_mass_.begin(), true_mass_.end(), 0.0);
}

double ShellModel::kinetic_energy() const
{
  double twice = 0.0;
  for (int i = 0; i < nodes(); ++i)
    twice +=
        mass_[i] * velocity_[i].squaredNorm() + inertia_[i] * angular_velocity_[i].squaredNorm();
  return 0.5 * twice;
}

}  // namespace encased_column
