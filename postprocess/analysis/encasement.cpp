// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/encasement.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

double mobilised_sine(double deviatoric_stress, double confining_stress)
{
  return deviatoric_stress / (2.0 * confining_stress + deviatoric_stress);
}

double passive_coefficient(double sine)
{
  return (1.0 + sine) / (1.0 - sine);
}

double stretched_radius(double initial_radius, double hoop_strain)
{
  return initial_radius * (1.0 + hoop_strain);
}

double confinement_of_ring(double hoop_tension, double radius)
{
  return hoop_tension / radius;
}

double encased_deviatoric_stress(double passive, double confining_stress, double extra_confinement)
{
  return passive * (confining_stress + extra_confinement) - confining_stress;
}

double friction_share(double friction_force, double stress_top, double stress_bottom, double area)
{
  const double larger = std::max(stress_top, stress_bottom) * area;
  return larger > 0.0 ? std::abs(friction_force) / larger : 0.0;
}

}  // namespace encased_column
