#include "contact/contact_row.h"

#include "core/vector_units.h"

namespace encased_column {

// The arithmetic of resolve_contact() and linear_contact(), written out: three components of a
// vector are three rows here. Where a contact does not slide, what is kept is the trial itself and
// the loss is zero without a branch.
template <bool dashpots>
[[gnu::always_inline]] inline double ContactRow::resolve_as(double dt, double step, bool advance)
{
  const double moves = advance ? 1.0 : 0.0, stays = 1.0 - moves, way = advance ? dt : 0.0;
  const double slack = slider_slack(advance);
  double loss = 0.0, dashpot_loss = 0.0;
#pragma omp simd reduction(+ : loss, dashpot_loss)
  for (int n = 0; n < count_; ++n) {
    const double ax = normal_[0][n], ay = normal_[1][n], az = normal_[2][n];
    const double r_i = radius_i_[n], r_j = radius_j_[n], length = r_i + r_j;
    const double distance = std::sqrt(ax * ax + ay * ay + az * az);
    // A first touch is as small as round-off, which must neither pull nor divide zero by zero.
    const double overlap = length > distance ? length - distance : 0.0;
    const double nx = ax / distance, ny = ay / distance, nz = az / distance;
    normal_[0][n] = nx;
    normal_[1][n] = ny;
    normal_[2][n] = nz;
    overlap_[n] = overlap;

    const double smaller = r_j > 0.0 && r_j < r_i ? r_j : r_i;
    const double k_n = pi * smaller * smaller * modulus_[n] / length;
    const double k_t = k_n / ratio_[n];
    const double elastic_normal = k_n * overlap;

    // Arms are the radii less half the overlap.
    const double lx = rolled_[0][n] - 0.5 * overlap * spin_[0][n];
    const double ly = rolled_[1][n] - 0.5 * overlap * spin_[1][n];
    const double lz = rolled_[2][n] - 0.5 * overlap * spin_[2][n];
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
      dashpot_loss += share_[n] * (pressing - elastic_normal) * closing * way;
    }

    const double old = seen_[n] < step - 1.0 ? 0.0 : 1.0;  // one that was not there starts anew
    const double sx = old * spring_[0][n], sy = old * spring_[1][n], sz = old * spring_[2][n];

    // laid_into_plane()
    const double along = moves * (sx * nx + sy * ny + sz * nz);
    const double square = sx * sx + sy * sy + sz * sz + no_square;
    const double least = square / (longest_stretch * longest_stretch);
    const double left = square - along * along;
    const double stretch = std::sqrt(square / (left > least ? left : least));
    const double px = stretch * (sx - along * nx), py = stretch * (sy - along * ny),
                 pz = stretch * (sz - along * nz);

    // half_turn(); the quarter of the mean of both spins
    const double twist = spin_[0][n] * nx + spin_[1][n] * ny + spin_[2][n] * nz;
    const double free = 0.125 * twist * way;
    const double below = free < largest_quarter ? free : largest_quarter;
    const double quarter = below > -largest_quarter ? below : -largest_quarter;
    const double scale = 1.0 / (1.0 + quarter * quarter);
    const double cosine = (1.0 - quarter * quarter) * scale, sine = 2.0 * quarter * scale;
    const double bx = cosine * px + sine * (ny * pz - nz * py),
                 by = cosine * py + sine * (nz * px - nx * pz),
                 bz = cosine * pz + sine * (nx * py - ny * px);

    const double tx = bx + vx * way, ty = by + vy * way, tz = bz + vz * way;
    const double elastic = k_t * std::sqrt(tx * tx + ty * ty + tz * tz);
    const double limit = friction_[n] * pressing * slack;
    const double part = elastic > limit ? limit / elastic : 1.0;
    part_[n] = part;
    const double gx = part * tx, gy = part * ty, gz = part * tz;
    loss += share_[n] * 0.5 * k_t *
            ((bx + gx) * (tx - gx) + (by + gy) * (ty - gy) + (bz + gz) * (tz - gz));
    const double kx = cosine * gx + sine * (ny * gz - nz * gy),
                 ky = cosine * gy + sine * (nz * gx - nx * gz),
                 kz = cosine * gz + sine * (nx * gy - ny * gx);
    // As sums: a choice by `advance` keeps the compiler from the vector units.
    spring_[0][n] = moves * kx + stays * tx;
    spring_[1][n] = moves * ky + stays * ty;
    spring_[2][n] = moves * kz + stays * tz;

    double fx = -k_t * kx, fy = -k_t * ky, fz = -k_t * kz;
    if (dashpots) {
      const double sticks = elastic > limit ? 0.0 : 1.0;  // a slider at its limit has no dashpot
      const double c_t = sticks * 2.0 * damping_shear_[n] * std::sqrt(mass_[n] * k_t);
      fx -= c_t * vx;
      fy -= c_t * vy;
      fz -= c_t * vz;
      dashpot_loss += share_[n] * c_t * (vx * vx + vy * vy + vz * vz) * way;
    }
    force_[0][n] = fx - pressing * nx;
    force_[1][n] = fy - pressing * ny;
    force_[2][n] = fz - pressing * nz;
    twist_[0][n] = ny * fz - nz * fy;
    twist_[1][n] = nz * fx - nx * fz;
    twist_[2][n] = nx * fy - ny * fx;
    normal_force_[n] = pressing;
    normal_stiffness_[n] = k_n;
    shear_stiffness_[n] = k_t;
  }
  dashpot_loss_ = dashpot_loss;
  return loss;
}

ENCASE_VECTOR_UNITS
double ContactRow::resolve_springs(double dt, double step, bool advance)
{
  return resolve_as<false>(dt, step, advance);
}

ENCASE_VECTOR_UNITS
double ContactRow::resolve_with_dashpots(double dt, double step, bool advance)
{
  return resolve_as<true>(dt, step, advance);
}

}  // namespace encased_column
