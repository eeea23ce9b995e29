#pragma once

#include <cmath>

namespace encased_column {

/// Inertial number I = rate d sqrt(rho / p) [-]: below 1e-3 shear is quasi-static.
/// `rate` [1/s] of strain, `d` [m] grain size, `density` [kg/m^3] of the grains' inertial mass, `p`
/// [Pa] mean stress.
/// Source: GDR MiDi (2004), Eur. Phys. J. E 14, 341-365.
inline double inertial_number(double rate, double d, double density, double p)
{
  return std::abs(rate) * d * std::sqrt(density / p);
}

}  // namespace encased_column
