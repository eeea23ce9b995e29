// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <algorithm>
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
  double yielding = 0.0;
};

/// Energy [J] between two states, both sides of the account, neither below zero.
struct EnergyFlow {
  double in = 0.0;   ///< stored and kinetic at the start, works on the grains
  double out = 0.0;  ///< stored and kinetic now, works of the grains, losses
};

inline EnergyFlow energy_flow(const EnergyAccount& start, const EnergyAccount& now)
{
  EnergyFlow flow{start.elastic + start.kinetic, now.elastic + now.kinetic};
  for (const auto work :
       {&EnergyAccount::work_platens, &EnergyAccount::work_side, &EnergyAccount::work_gravity}) {
    const double done = now.*work - start.*work;
    (done > 0.0 ? flow.in : flow.out) += std::abs(done);
  }
  for (const auto loss :
       {&EnergyAccount::friction, &EnergyAccount::rolling, &EnergyAccount::dashpots,
        &EnergyAccount::damping, &EnergyAccount::yielding}) {
    const double lost = now.*loss - start.*loss;
    (lost > 0.0 ? flow.out : flow.in) += std::abs(lost);
  }
  return flow;
}

/// What does not close since a start, as a fraction of all energy that took part: of the larger
/// side of the account, at the time when that was largest. So it is 1 where energy comes from
/// nothing, and round-off where a specimen has given back all it had stored.
class EnergyBalance {
 public:
  void start(const EnergyAccount& account)
  {
    start_ = account;
    most_ = 0.0;
  }
  /// Of a restart file.
  void resume(const EnergyAccount& start, double most)
  {
    start_ = start;
    most_ = most;
  }
  /// The fraction [-] at a state, which counts from then on as one that was seen.
  double error(const EnergyAccount& now)
  {
    const EnergyFlow flow = energy_flow(start_, now);
    most_ = std::max({most_, flow.in, flow.out});
    return most_ > 0.0 ? std::abs(flow.in - flow.out) / most_ : 0.0;
  }
  double most() const { return most_; }  ///< energy [J] seen on one side of the account

 private:
  EnergyAccount start_;
  double most_ = 0.0;
};

}  // namespace encased_column
