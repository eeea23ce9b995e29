// What grains and contacts add up to in the spheres.
#include "measure/fix_measure_sphere.h"

#include "core/input_error.h"
#include "host/rank_sums.h"
#include "measure/sphere_overlap.h"

#include <algorithm>
#include <type_traits>

namespace encased_column {

namespace {

/// Fewer and the numbers of a sphere depend on where it stands.
/// Source: the study, section 2.2.2.
constexpr double fewest_grains = 2000.0;

/// The six numbers of a tensor, the mean of both triangles off the diagonal.
std::vector<double> six(const Mat3& t)
{
  const auto off = [&t](int a, int b) { return 0.5 * (t(a, b) + t(b, a)); };
  return {t(0, 0), t(1, 1), t(2, 2), off(0, 1), off(0, 2), off(1, 2)};
}

}  // namespace

template <typename Visit>
void FixMeasureSphere::for_images(const MeasuringSphere& sphere, const Vec3& x, double reach,
                                  const Visit& visit) const
{
  const Vec3 around = Vec3::Constant(reach);
  box_.for_images(x, sphere.center - around, sphere.center + around, visit);
}

void FixMeasureSphere::add_contact(const Contact& contact)
{
  const bool pair_here = contact.j >= 0 && contact.j < atom->nlocal;
  ++contacts_of_[contact.i];
  if (pair_here) ++contacts_of_[contact.j];
  const double radius = atom->radius[contact.i];
  const Vec3 x = as_vec3(atom->x[contact.i]);
  for (std::size_t n = 0; n < spheres_.size(); ++n) {
    const MeasuringSphere& sphere = spheres_[n];
    // Neither grain nor their contact lies farther from the first one than the other.
    const double reach = sphere.radius + contact.length;
    for_images(sphere, x, reach, [&](const Vec3& shift) {
      if ((x + shift - sphere.center).squaredNorm() > reach * reach) return;
      const Vec3 point = x + shift + contact.arm * contact.normal;
      const double force = contact.force.norm();
      const double volume =
          contact.j < 0 ? sphere_cap_volume(radius, contact.length)
                        : sphere_overlap_volume(radius, atom->radius[contact.j], contact.length);
      add_contact_end(sums_[n], sphere, x + shift, contact.force, contact.arm * contact.normal);
      if (pair_here)
        add_contact_end(sums_[n], sphere, as_vec3(atom->x[contact.j]) + shift, -contact.force,
                        -(contact.length - contact.arm) * contact.normal);
      encased_column::add_contact(sums_[n], sphere, point, contact.normal, volume, force,
                                  contact.sliding, contact.share);
      if (sphere.holds(point)) largest_force_[n] = std::max(largest_force_[n], force);
    });
  }
}

void FixMeasureSphere::take_sample()
{
  static_assert(std::is_trivially_copyable_v<SphereSums>);
  sampled_ = true;
  for (std::size_t n = 0; n < spheres_.size(); ++n) {
    for (int i = 0; i < atom->nlocal; ++i) {
      const Vec3 x = as_vec3(atom->x[i]);
      for_images(spheres_[n], x, spheres_[n].radius + atom->radius[i], [&](const Vec3& shift) {
        add_grain(sums_[n], spheres_[n], x + shift, atom->radius[i], contacts_of_[i]);
      });
    }
    largest_force_[n] = max_over_ranks(largest_force_[n], world);
  }
  sum_over_ranks(&sums_.front().solid,
                 static_cast<int>(sums_.size() * sizeof(SphereSums) / sizeof(double)), world);
  for (std::size_t n = 0; n < spheres_.size(); ++n) {
    const MeasuringSphere& sphere = spheres_[n];
    const SphereMeasure m = measure(sums_[n], sphere);
    std::vector<double>& row = rows_[n];
    row = {static_cast<double>(update->ntimestep),
           static_cast<double>(n + 1),
           sphere.center.x(),
           sphere.center.y(),
           sphere.center.z(),
           sphere.radius,
           m.grains,
           m.porosity,
           m.porosity_less_overlap,
           m.coordination_number,
           m.coordination_number_bearing,
           m.axial,
           m.radial,
           m.hoop};
    for (const double number : six(m.stress)) row.push_back(number);
    for (const double number : six(m.fabric)) row.push_back(number);
    row.insert(row.end(), {m.sliding_fraction, m.mean_force, largest_force_[n]});
  }
  warn_of_few_grains();
}

void FixMeasureSphere::warn_of_few_grains()
{
  if (warned_) return;
  for (std::size_t n = 0; n < spheres_.size(); ++n) {
    if (sums_[n].grains >= fewest_grains) continue;
    warned_ = true;
    if (comm->me == 0)
      error->warning(
          FLERR,
          ("measuring sphere " + std::to_string(n + 1) + " of fix '" + id + "' holds " +
           in_words(sums_[n].grains) + " grains at step " + std::to_string(update->ntimestep) +
           ", take a larger one: below 2000 its numbers depend on where it stands")
              .c_str());
    return;
  }
}

}  // namespace encased_column
