// SPDX-License-Identifier: GPL-2.0-only
#include "measure/sphere_sampler.h"

#include "core/input_error.h"
#include "core/keyword_table.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace encased_column {

static_assert(std::is_trivially_copyable_v<SphereSums>);

SphereSampler::SphereSampler(const Options& options)
{
  Vec3 axis = Vec3::Zero();
  const auto number_at = [](const std::vector<std::string>& words, int n) {
    return read_number("sphere", words[n]);
  };
  if (options.has("axis"))
    for (int a = 0; a < 2; ++a) axis(a) = number_at(options.all("axis").front(), a);
  const auto add = [&](const Vec3& center, double radius) {
    if (!(radius > 0.0))
      throw InputError("the radius of a measuring sphere must be larger than zero, found " +
                       in_words(radius) + ", write a length in m");
    spheres_.push_back({center, radius, axis});
  };
  if (options.has("sphere"))
    for (const auto& words : options.all("sphere"))
      add({number_at(words, 0), number_at(words, 1), number_at(words, 2)}, number_at(words, 3));
  if (options.has("stack") != options.has("platens"))
    throw InputError(
        "'stack' and 'platens' go together, found one of them alone, write for "
        "example 'stack 3 0.04 platens top bottom'");
  if (options.has("stack")) {
    const auto& words = options.all("stack").front();
    const double wanted = number_at(words, 0);
    if (!(wanted >= 1.0 && wanted <= 1000.0 && wanted == std::floor(wanted)))
      throw InputError("'stack' takes a whole number of spheres from 1 to 1000, found " + words[0] +
                       ", write for example 'stack 3 0.04'");
    stack_ = static_cast<std::size_t>(wanted);
    for (std::size_t n = 0; n < stack_; ++n) add(axis, number_at(words, 1));
  }
  if (spheres_.empty())
    throw InputError(
        "'measure/sphere' needs 'sphere' or 'stack', found neither, write for example "
        "'sphere 0 0 0.1 0.04'");
  options.assume("axis", "0 0");
}

void SphereSampler::start(const PeriodicBox& box, const HeightWindow& window)
{
  box_ = box;
  place_stack(window);
  sums_.assign(spheres_.size(), SphereSums());
  largest_force_.assign(spheres_.size(), 0.0);
}

void SphereSampler::place_stack(const HeightWindow& window)
{
  const std::size_t first = spheres_.size() - stack_;
  for (std::size_t n = 0; n < stack_; ++n) {
    MeasuringSphere& sphere = spheres_[first + n];
    sphere.center.z() =
        window.level_in_stack(static_cast<int>(n), static_cast<int>(stack_), sphere.radius);
  }
}

template <typename Visit>
void SphereSampler::for_images(const MeasuringSphere& sphere, const Vec3& x, double reach,
                               const Visit& visit) const
{
  const Vec3 around = Vec3::Constant(reach);
  box_.for_images(x, sphere.center - around, sphere.center + around, visit);
}

void SphereSampler::add(const SeenContact& contact)
{
  for (std::size_t n = 0; n < spheres_.size(); ++n) {
    const MeasuringSphere& sphere = spheres_[n];
    // Neither grain nor their contact lies farther from the first one than the other.
    const double reach = sphere.radius + contact.length;
    for_images(sphere, contact.at_i, reach, [&](const Vec3& shift) {
      const Vec3 x = contact.at_i + shift;
      if ((x - sphere.center).squaredNorm() > reach * reach) return;
      const Vec3 point = x + contact.lever_i();
      const double force = contact.force.norm();
      add_contact_end(sums_[n], sphere, x, contact.force, contact.lever_i());
      if (contact.counts_j)
        add_contact_end(sums_[n], sphere, contact.at_j + shift, -contact.force, contact.lever_j());
      add_contact(sums_[n], sphere, point, contact.normal, contact.shared_volume(), force,
                  contact.sliding, contact.share);
      if (sphere.holds(point)) largest_force_[n] = std::max(largest_force_[n], force);
    });
  }
}

void SphereSampler::add_grain(const Vec3& x, double radius, int contacts)
{
  for (std::size_t n = 0; n < spheres_.size(); ++n)
    for_images(spheres_[n], x, spheres_[n].radius + radius, [&](const Vec3& shift) {
      encased_column::add_grain(sums_[n], spheres_[n], x + shift, radius, contacts);
    });
}

std::vector<SphereRow> SphereSampler::samples(double step) const
{
  std::vector<SphereRow> rows;
  for (std::size_t n = 0; n < spheres_.size(); ++n)
    rows.push_back({step, static_cast<double>(n + 1), spheres_[n], measure(sums_[n], spheres_[n]),
                    largest_force_[n]});
  return rows;
}

}  // namespace encased_column
