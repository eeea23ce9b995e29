// SPDX-License-Identifier: GPL-2.0-only
#include "contact/contact_batch.h"

#include "core/vector_units.h"

namespace encased_column {

// The arithmetic of resolve_contact() and linear_contact(), written out: three components of a
// vector are three rows here. Where a contact does not slide, what is kept is the trial itself and
// the loss is zero without a branch. One template for both was tried: with the formulas of
// linear_law.h on one contact a lane, as facet_batches_resolve.cpp does it, resolve() takes 1.27
// times as long with their branches taken out and 4.8 times as long as they stand (16.0, 20.7 and
// 77.9 ns a contact, 3000 short runs of each in turn, AVX-512), and the last bits of forces change.
//
// Two loops, so that one contact's divisions and roots need not wait for another's: the machine
// looks ahead by some two hundred instructions.
template <bool dashpots, bool advance>
[[gnu::always_inline]] inline double ContactBatch::resolve_as(double dt, double step)
{
  const double slack = slider_slack(advance);
  double loss = 0.0, dashpot_loss = 0.0;
#pragma omp simd reduction(+ : loss, dashpot_loss)
  for (int n = 0; n < count_; ++n) {
    const double ax = normal_[0][n], ay = normal_[1][n], az = normal_[2][n];
    const double r_i = radius_i_[n], r_j = radius_j_[n], length = r_i + r_j;
    const double apart_square = ax * ax + ay * ay + az * az;
    const double distance = std::sqrt(apart_square);
    // A first touch is as small as round-off, which must neither pull nor divide zero by zero.
    const double overlap = (length > distance ? length - distance : 0.0) + more_[n];
    // One division for all three: the vector units take longest over those.
    const double product = 1.0 / (distance * length * ratio_[n]);
    const double near = product * length * ratio_[n];
    per_length_[n] = product * distance * ratio_[n];
    const double nx = near * ax, ny = near * ay, nz = near * az;
    normal_[0][n] = nx;
    normal_[1][n] = ny;
    normal_[2][n] = nz;
    overlap_[n] = overlap;

    const double smaller = r_j > 0.0 && r_j < r_i ? r_j : r_i;
    const double k_t = pi * smaller * smaller * modulus_[n] * (product * distance);
    const double k_n = k_t * ratio_[n];
    const double elastic_normal = k_n * overlap;

    // Arms are the radii less half the overlap.
    const double ix = spin_i_[0][n], iy = spin_i_[1][n], iz = spin_i_[2][n];
    const double jx = spin_j_[0][n], jy = spin_j_[1][n], jz = spin_j_[2][n];
    const double lx = r_i * ix + r_j * jx - 0.5 * overlap * (ix + jx);
    const double ly = r_i * iy + r_j * jy - 0.5 * overlap * (iy + jy);
    const double lz = r_i * iz + r_j * jz - 0.5 * overlap * (iz + jz);
    double vx = velocity_[0][n], vy = velocity_[1][n], vz = velocity_[2][n];

    // Slip: what is left of the velocity in the contact plane, with what the spins add.
    const double closing = vx * nx + vy * ny + vz * nz;
    vx = vx - closing * nx + (ly * nz - lz * ny);
    vy = vy - closing * ny + (lz * nx - lx * nz);
    vz = vz - closing * nz + (lx * ny - ly * nx);

    double pressing = elastic_normal;
    if (dashpots) {
      const double damped =
          elastic_normal + 2.0 * damping_normal_[n] * std::sqrt(mass_[n] * k_n) * closing;
      pressing = damped > 0.0 ? damped : 0.0;
      if (advance) dashpot_loss += share_[n] * (pressing - elastic_normal) * closing * dt;
    }

    const double old = seen_[n] < step - 1.0 ? 0.0 : 1.0;  // a new contact starts from zero
    double sx = old * spring_[0][n], sy = old * spring_[1][n], sz = old * spring_[2][n];

    if (advance) {
      // laid_into_plane() and half_turn(), their divisions by squares of `apart`, so that they need
      // not wait for its length; the quarter is of the mean of both spins.
      const double along = sx * ax + sy * ay + sz * az;
      const double square = apart_square * (sx * sx + sy * sy + sz * sz + no_square);
      const double least = square / (longest_stretch * longest_stretch);
      const double left = square - along * along;
      const double stretch = std::sqrt(square / (left > least ? left : least));
      const double out = along * near;
      const double px = stretch * (sx - out * nx), py = stretch * (sy - out * ny),
                   pz = stretch * (sz - out * nz);

      const double twist = (0.125 * dt) * ((ix + jx) * ax + (iy + jy) * ay + (iz + jz) * az);
      const double most = largest_quarter * largest_quarter * apart_square;
      const double turn = twist * twist < most ? twist * twist : most;
      const double scale = 1.0 / (apart_square + turn);
      const double free = twist * near;
      const double below = free < largest_quarter ? free : largest_quarter;
      const double quarter = below > -largest_quarter ? below : -largest_quarter;
      const double cosine = (apart_square - turn) * scale,
                   sine = 2.0 * quarter * apart_square * scale;
      cosine_[n] = cosine;
      sine_[n] = sine;
      sx = cosine * px + sine * (ny * pz - nz * py);
      sy = cosine * py + sine * (nz * px - nx * pz);
      sz = cosine * pz + sine * (nx * py - ny * px);
    } else {
      cosine_[n] = 1.0;
      sine_[n] = 0.0;
    }
    spring_[0][n] = sx;
    spring_[1][n] = sy;
    spring_[2][n] = sz;
    velocity_[0][n] = vx;
    velocity_[1][n] = vy;
    velocity_[2][n] = vz;
    normal_force_[n] = pressing;
    normal_stiffness_[n] = k_n;
    shear_stiffness_[n] = k_t;
  }
#pragma omp simd reduction(+ : loss, dashpot_loss)
  for (int n = 0; n < count_; ++n) {
    const double nx = normal_[0][n], ny = normal_[1][n], nz = normal_[2][n];
    const double vx = velocity_[0][n], vy = velocity_[1][n], vz = velocity_[2][n];
    const double pressing = normal_force_[n], k_t = shear_stiffness_[n];
    const double bx = spring_[0][n], by = spring_[1][n], bz = spring_[2][n];

    double tx = bx, ty = by, tz = bz;
    if (advance) tx += vx * dt, ty += vy * dt, tz += vz * dt;
    const double elastic = k_t * std::sqrt(tx * tx + ty * ty + tz * tz);
    const double limit = friction_[n] * pressing * slack;
    const double part = elastic > limit ? limit / elastic : 1.0;
    part_[n] = part;
    double kx = part * tx, ky = part * ty, kz = part * tz;
    if (advance) {
      loss += share_[n] * 0.5 * k_t *
              ((bx + kx) * (tx - kx) + (by + ky) * (ty - ky) + (bz + kz) * (tz - kz));
      const double cosine = cosine_[n], sine = sine_[n];
      const double cx = ny * kz - nz * ky, cy = nz * kx - nx * kz, cz = nx * ky - ny * kx;
      kx = cosine * kx + sine * cx;
      ky = cosine * ky + sine * cy;
      kz = cosine * kz + sine * cz;
      spring_[0][n] = kx;
      spring_[1][n] = ky;
      spring_[2][n] = kz;
    }

    double fx = -k_t * kx, fy = -k_t * ky, fz = -k_t * kz;
    if (dashpots) {
      const double sticks = elastic > limit ? 0.0 : 1.0;  // a slider at its limit has no dashpot
      const double c_t = sticks * 2.0 * damping_shear_[n] * std::sqrt(mass_[n] * k_t);
      fx -= c_t * vx;
      fy -= c_t * vy;
      fz -= c_t * vz;
      if (advance) dashpot_loss += share_[n] * c_t * (vx * vx + vy * vy + vz * vz) * dt;
    }
    force_[0][n] = fx - pressing * nx;
    force_[1][n] = fy - pressing * ny;
    force_[2][n] = fz - pressing * nz;
    const double ax = ny * fz - nz * fy, ay = nz * fx - nx * fz, az = nx * fy - ny * fx;
    const double arm_i = contact_arm(radius_i_[n], overlap_[n]);
    const double arm_j = contact_arm(radius_j_[n], overlap_[n]);
    moment_i_[0][n] = arm_i * ax;
    moment_i_[1][n] = arm_i * ay;
    moment_i_[2][n] = arm_i * az;
    moment_j_[0][n] = arm_j * ax;
    moment_j_[1][n] = arm_j * ay;
    moment_j_[2][n] = arm_j * az;
  }
  dashpot_loss_ = dashpot_loss;
  return loss;
}

ENCASE_VECTOR_UNITS
double ContactBatch::resolve_springs(double dt, double step, bool advance)
{
  return advance ? resolve_as<false, true>(dt, step) : resolve_as<false, false>(dt, step);
}

ENCASE_VECTOR_UNITS
double ContactBatch::resolve_with_dashpots(double dt, double step, bool advance)
{
  return advance ? resolve_as<true, true>(dt, step) : resolve_as<true, false>(dt, step);
}

}  // namespace encased_column
