// SPDX-License-Identifier: GPL-2.0-only
#include "specimen/specimen.h"

namespace encased_column {

double Specimen::volume() const
{
  return side_->enclosed_volume(window().low, window().high);
}

SpecimenState Specimen::state() const
{
  SpecimenState s;
  s.height = height();
  s.volume = volume();
  for (int n = 0; n < 3; ++n) s.radius[n] = side_->radius_at(window().level(0.25 * (n + 1)));
  s.stress_top = platens_.top->stress();
  s.stress_bottom = platens_.bottom->stress();
  s.confining_stress = side_->confining_stress();
  return s;
}

Vec3 Specimen::outward(const Vec3& x) const
{
  Vec3 outward = x - side_->axis();
  outward.z() = 0.0;
  outward.normalize();
  return outward;
}

int Specimen::count_outside(const double* centers, int count) const
{
  return side_->count_outside(centers, count, window().low, window().high);
}

}  // namespace encased_column
