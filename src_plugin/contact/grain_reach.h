// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <algorithm>
#include <vector>

namespace encased_column {

/// How far [m] each grain may be from where the last list of pairs found it: half the `skin` of the
/// host [m], or what its own `reach` says.
class GrainReach {
 public:
  explicit GrainReach(double skin, const double* reach = nullptr)
      : half_skin_(0.5 * skin),
        reach_(reach)
  {
  }
  double skin() const { return 2.0 * half_skin_; }
  double operator[](int i) const { return reach_ ? reach_[i] : half_skin_; }
  /// How near [m] to grain i a surface that moves by half a skin must be for a list that is made
  /// while the grain may be anywhere in its reach, and holds until it leaves it.
  double margin(int i) const { return 2.0 * (*this)[i] + half_skin_; }

 private:
  double half_skin_;
  const double* reach_;
};

/// How the reach of a grain follows its speed.
struct ReachRule {
  double least = 0.0;    ///< [m]
  double range = 0.0;    ///< no two grains farther apart are found [m]
  double factor = 1.0;   ///< on their radii in that [-]
  double horizon = 0.0;  ///< a grain stays inside for so long at its speed [s]

  /// Of a grain of `radius` [m] at `velocity` [m/s].
  double reach(double radius, const Vec3& velocity) const
  {
    const double wanted = horizon * velocity.norm();
    return std::max(least, std::min(wanted, 0.5 * range - factor * radius));
  }
};

/// The grains of one rank, owned ones first: triples of vectors, one number of each scalar.
struct ListedGrains {
  const double* center = nullptr;    ///< [m]
  const double* velocity = nullptr;  ///< [m/s]
  const double* radius = nullptr;    ///< [m]
  int owned = 0, all = 0;
};

/// Of the owned ones [m/s].
double sum_of_speeds(const ListedGrains& grains);

/// The horizon [s] of grains that move at `mean_speed` [m/s]: those at that speed keep
/// again as the `least` reach [m].
inline double reach_horizon(double least, double mean_speed)
{
  return mean_speed > 0.0 ? least / mean_speed : 0.0;
}

/// How far grains may go until lists of pairs must be made again.
///
/// With one skin for all, the fastest grain decides: late in shear that is one of the few that are
/// squeezed out into a void, and lists are made again while most pairs have hardly moved. Here a
/// grain that is fast when lists are made gets a wider reach, so that lists hold longer, at the
/// cost of few pairs more.
class ReachAccount {
 public:
  /// Lists are made now. Afterwards reach() is that of all grains, ghosts too.
  void start(const ListedGrains& grains, const ReachRule& rule);
  /// True where a grain at one of `centers` [m] has left its reach around where the lists found it,
  /// `listed` [m]: known exactly, but looked at only when one can have. None went further than
  /// `way` [m] since this was asked last.
  bool is_left(const double* centers, const double* listed, double way);
  const std::vector<double>& reach() const { return reach_; }  ///< [m]

 private:
  std::vector<double> reach_;
  int owned_ = 0;
  double spare_ = 0.0;      ///< no grain leaves its reach within this way [m]
  double round_off_ = 0.0;  ///< of ways that are added up, each [m]
};

}  // namespace encased_column
