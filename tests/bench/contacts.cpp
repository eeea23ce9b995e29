// SPDX-License-Identifier: GPL-2.0-only
// What the contacts of a sleeve cost: finding facets, the law, and the loads of the nodes. By hand:
//
//   build/bin/bench_contacts
//
// With -DONE_BY_ONE the law takes one contact after the other; else blocks of them, as in a run.
#include "contact/contact_batch.h"
#include "shell/cylinder_mesh.h"
#include "shell/nearest_point.h"
#include "shell/sleeve_contacts.h"
#include "thread_time.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

using namespace encased_column;

namespace {

struct Grains {
  std::vector<double> x, radius;
  const double* centers = nullptr;
  const double* radii = nullptr;
  bool counts(int) const { return true; }
  void fetch(int, int) const {}
};

double distance(const ShellModel& model, const Vec3& x)
{
  double nearest = 1.0;
  for (int f = 0; f < model.facets(); ++f) {
    const FacetVectors c = model.corners(f);
    if ((c[0] - x).squaredNorm() > 4e-4) continue;
    const Vec3 w = nearest_on_triangle(c[0], c[1], c[2], x);
    nearest = std::min(nearest, (w(0) * c[0] + w(1) * c[1] + w(2) * c[2] - x).norm());
  }
  return nearest;
}

/// Grains of 1 to 5 mm inside the sleeve: a third of them 0.1 to 0.5 mm away, the others touch.
Grains grains_at(const ShellModel& model, int count)
{
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  Grains grains;
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307 * part(engine), z = 0.01 + 0.18 * part(engine);
    const double radius = 0.001 + 0.004 * part(engine);
    const double gap = i % 3 == 0 ? 1e-4 + 4e-4 * part(engine) : -2e-5 * part(engine);
    const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
    double depth = 0.0499 - radius;
    for (int n = 0; n < 3; ++n)
      depth += distance(model, depth * out + Vec3(0.0, 0.0, z)) - radius - gap;
    const Vec3 x = depth * out + Vec3(0.0, 0.0, z);
    grains.x.insert(grains.x.end(), x.data(), x.data() + 3);
    grains.radius.push_back(radius);
  }
  grains.centers = grains.x.data();
  grains.radii = grains.radius.data();
  return grains;
}

}  // namespace

int main()
{
  ShellConstants c;
  c.modulus_hoop = 11.5e6;
  c.thickness = 0.01;
  c.density = 30.0;
  ShellModel model(cylinder_mesh(TubeShape{0.05, 0.0, 0.2, 0.005}), c, Vec3::UnitZ());
  const int count = 3000;
  const Grains grains = grains_at(model, count);
  SleeveContacts contacts;
  contacts.list(model, grains.centers, grains.radii, count, 3e-4);
  const ContactMaterial material{7e7, 1.0, 0.8, 0.0, 0.0, 0.0};
  std::vector<double> memory(4 * count, 0.0);
  long step = 0, touching = 0;
#ifdef ONE_BY_ONE
  const auto law = [&](const SleeveContact& contact) -> SleeveReaction {
    ++touching;
    const double radius = grains.radius[contact.grain];
    const Touch touch{contact.merged.overlap,
                      contact.merged.normal,
                      1e-4,
                      {radius, Vec3::Zero(), Vec3::Zero()},
                      {0.0, contact.surface.velocity, contact.surface.spin}};
    const ContactAction action = resolve_contact<false>(stiffened(material, contact.merged), touch,
                                                        1e-6, step, true, &memory[4 * contact.n]);
    return {action.normal_force, action.force, action.moment_j, action.stiffness.normal};
  };
#else
  ContactBatch batch;
  const auto law = [&](const SleeveContact* contact, int number, SleeveReaction* reaction) {
    touching += number;
    for (int n = 0; n < number; ++n) {
      const double radius = grains.radius[contact[n].grain];
      batch.add(contact[n].grain, -1, 1.0, stiffened(material, contact[n].merged),
                radius * contact[n].merged.normal, {radius, Vec3::Zero(), Vec3::Zero()},
                contact[n].body(), 0.0, &memory[4 * contact[n].n], contact[n].merged.overlap);
    }
    batch.resolve(1e-6, static_cast<double>(step), true);
    batch.keep(static_cast<double>(step));
    for (int n = 0; n < number; ++n)
      reaction[n] = {batch.normal_force(n), batch.force(n), Vec3::Zero(),
                     batch.stiffness(n).normal};
    batch.clear();
  };
#endif
  std::vector<double> time;
  for (int turn = 0; turn < 301; ++turn) {
    ++step;
    model.clear_loads();
    touching = 0;
    const double before = thread_time();
    contacts.resolve(model, true, grains, nullptr, law);
    time.push_back(thread_time() - before);
  }
  Vec3 sum = Vec3::Zero();
  double size = 0.0;
  for (int i = 0; i < model.nodes(); ++i) sum += model.force(i), size += model.force(i).norm();
  std::sort(time.begin(), time.end());
  std::printf(
      "%ld of %d grains touch: %.0f ns a contact; sum of forces %.15g N, of their lengths %.15g "
      "N\n",
      touching, count, time[time.size() / 2] / static_cast<double>(touching), sum.norm(), size);
}
