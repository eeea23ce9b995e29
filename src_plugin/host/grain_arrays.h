#pragma once

#include "host/host_types.h"

namespace encased_column {

/// The host's arrays of owned and ghost grains without its rows of pointers, which cost a loop
/// over many grains a second wait for memory. Not for a rank that has no grain at all.
struct GrainArrays {
  explicit GrainArrays(LAMMPS_NS::Atom* a)
      : x(a->x[0]),
        v(a->v[0]),
        omega(a->omega[0]),
        radius(a->radius),
        mass(a->rmass),
        type(a->type),
        force(a->f[0]),
        moment(a->torque[0]),
        owned(a->nlocal)
  {
  }
  const double* __restrict x;      ///< [m]
  const double* __restrict v;      ///< [m/s]
  const double* __restrict omega;  ///< [rad/s]
  const double* __restrict radius;
  const double* __restrict mass;
  const int* __restrict type;
  double* __restrict force;   ///< [N]
  double* __restrict moment;  ///< [N m]
  int owned;
};

}  // namespace encased_column
