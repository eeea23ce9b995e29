#pragma once

#include <cmath>

namespace encased_column {

/// Energy of a specimen [J]: what came in, what is stored, what was lost.
struct EnergyAccount {
  double work_platens = 0.0;
  double work_side = 0.0;
  double work_gravity = 0.0;
  double elastic = 0.0;
  double kinetic = 0.0;
  double friction = 0.0;
  double rolling = 0.0;
  double dashpots = 0.0;
  double damping = 0.0;
};

/// What does not close between two states, as a fraction of the energy that was at hand: stored at
/// the start plus the platens' and the side's work, in absolute terms. Work in = gain + lost.
inline double energy_error(const EnergyAccount& start, const EnergyAccount& now)
{
  const double platens = now.work_platens - start.work_platens;
  const double side = now.work_side - start.work_side;
  const double gravity = now.work_gravity - start.work_gravity;
  const double gain = now.elastic - start.elastic + now.kinetic - start.kinetic;
  const double lost = now.friction - start.friction + now.rolling - start.rolling + now.dashpots -
                      start.dashpots + now.damping - start.damping;
  const double at_hand = start.elastic + std::abs(platens) + std::abs(side);
  return at_hand > 0.0 ? std::abs(platens + side + gravity - gain - lost) / at_hand : 0.0;
}

}  // namespace encased_column
