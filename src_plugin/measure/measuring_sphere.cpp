// SPDX-License-Identifier: GPL-2.0-only
#include "measure/measuring_sphere.h"

#include "measure/seen_contact.h"
#include "measure/sphere_overlap.h"
#include "specimen/specimen.h"

namespace encased_column {

namespace {

/// Nine numbers in a row, seen as a tensor.
using Rows = Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
using ConstRows = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

}  // namespace

void add_grain(SphereSums& sums, const MeasuringSphere& sphere, const Vec3& x, double radius,
               int contacts)
{
  sums.solid += sphere_overlap_volume(sphere.radius, radius, (x - sphere.center).norm());
  if (!sphere.holds(x)) return;
  sums.grains += 1.0;
  sums.grain_volume += sphere_volume(radius);
  sums.ends += contacts;
  sums.without_contact += contacts == 0;
  sums.with_one_contact += contacts == 1;
}

void add_contact_end(SphereSums& sums, const MeasuringSphere& sphere, const Vec3& x,
                     const Vec3& force, const Vec3& lever)
{
  if (!sphere.holds(x)) return;
  Rows(sums.stress) -= force * lever.transpose();
  // On the axis itself every direction across is radial and hoop alike.
  const Vec3 across(x.x() - sphere.axis.x(), x.y() - sphere.axis.y(), 0.0);
  const bool on_axis = across.isZero(0.0);
  const Vec3 outward = on_axis ? Vec3(Vec3::UnitX()) : Vec3(across.normalized());
  const double radial = love_weber(force, lever, outward);
  const double hoop = love_weber(force, lever, Vec3::UnitZ().cross(outward));
  sums.radial += on_axis ? 0.5 * (radial + hoop) : radial;
  sums.hoop += on_axis ? 0.5 * (radial + hoop) : hoop;
}

void add_contact(SphereSums& sums, const MeasuringSphere& sphere, const Vec3& point,
                 const Vec3& normal, double shared_volume, double force, bool sliding, double share)
{
  if (!sphere.holds(point)) return;
  sums.shared += share * shared_volume;
  sums.contacts += share;
  sums.sliding += sliding ? share : 0.0;
  sums.force += share * force;
  Rows(sums.fabric) += share * normal * normal.transpose();
}

SphereMeasure measure(const SphereSums& sums, const MeasuringSphere& sphere)
{
  const double volume = sphere_volume(sphere.radius);
  const ContactCount count{sums.grains, sums.ends, sums.without_contact, sums.with_one_contact};
  SphereMeasure m{};
  m.grains = sums.grains;
  m.porosity = porosity(sums.solid, volume);
  m.porosity_less_overlap = porosity(sums.solid - sums.shared, volume);
  m.coordination_number = coordination_number(count);
  m.mechanical_coordination_number = mechanical_coordination_number(count);
  const double per_volume = sums.grain_volume > 0.0 ? (1.0 - m.porosity) / sums.grain_volume : 0.0;
  m.stress = per_volume * ConstRows(sums.stress);
  m.axial = m.stress(2, 2);
  m.radial = per_volume * sums.radial;
  m.hoop = per_volume * sums.hoop;
  if (sums.contacts > 0.0) {
    m.fabric = ConstRows(sums.fabric) / sums.contacts;
    m.sliding_fraction = sums.sliding / sums.contacts;
    m.mean_force = sums.force / sums.contacts;
  } else {
    m.fabric = Mat3::Zero();
  }
  return m;
}

}  // namespace encased_column
