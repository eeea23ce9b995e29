// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace encased_column {

/// How the reach of a grain follows its speed.
struct ReachRule {
  double least = 0.0;    ///< [m]
  double range = 0.0;    ///< no two grains farther apart are found [m]
  double factor = 1.0;   ///< on their radii in that [-]
  double horizon = 0.0;  ///< a grain stays inside for so long at its speed [s]
  /// Width of the thinnest rank [m]: only the next ones take grains over when lists are made.
  double thinnest = std::numeric_limits<double>::infinity();
  /// Corners [m] of the rank; infinite where neither another rank nor an image lies beyond.
  Vec3 low = Vec3::Constant(-std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(std::numeric_limits<double>::infinity());
  double beyond = 0.0;  ///< ghosts come from so much farther than lists with `least` ask for [m]

  /// Of a grain of `radius` [m] at `velocity` [m/s] when lists are made.
  double reach(double radius, const Vec3& velocity) const
  {
    return std::max(least, std::min(horizon * velocity.norm(), most(radius)));
  }
  /// Of one that has `gone` so far [m] that it has left its reach; not larger where there is no
  /// more.
  double wider_reach(double radius, const Vec3& velocity, double gone) const
  {
    return std::min(2.0 * gone + horizon * velocity.norm(), most(radius));
  }
  double most(double radius) const  ///< [m]
  {
    return std::min(0.5 * range - factor * radius, thinnest);
  }
  /// What of a `reach` [m] is left to a grain that is listed at `center` [m]. The host brings as
  /// ghosts those that are within the largest radius, the skin and their own radius of the border,
  /// not within `range` of the grains behind it. One that goes farther than half the skin must be
  /// a ghost there already, or not get near what lies behind.
  double known_beyond(double reach, double radius, const Vec3& center) const
  {
    const double inside = std::min((center - low).minCoeff(), (high - center).minCoeff());
    return std::min(reach, std::max(least + beyond, inside - 0.5 * range - factor * radius));
  }
};

/// The horizon [s] of grains that move at `mean_speed` [m/s]: those at that speed keep the `least`
/// reach [m].
inline double reach_horizon(double least, double mean_speed)
{
  return mean_speed > 0.0 ? least / mean_speed : 0.0;
}

/// The grains of one rank, owned ones first: triples of vectors, one number of each scalar.
struct ListedGrains {
  const double* center = nullptr;    ///< [m]
  const double* velocity = nullptr;  ///< [m/s]
  const double* radius = nullptr;    ///< [m]
  int owned = 0, all = 0;
};

/// Of the owned ones [m/s].
double sum_of_speeds(const ListedGrains& grains);

/// How far grains may go until lists of pairs must be made again.
///
/// With one skin for all, the fastest grain decides: late in shear that is one of the few that are
/// squeezed out into a void, and lists are made again while most pairs have hardly moved. Here a
/// grain that is fast when lists are made gets a wider reach. The few that get fast later have
/// theirs widened, and what they may touch is added to the lists.
class ReachAccount {
 public:
  enum class Answer { lists_hold, some_are_wider, lists_end };

  static constexpr int most_wider = 16;  ///< grains of a rank, in the time of one list

  /// Lists are made now. Ghosts have the least reach until set_reach() and forget_wider().
  void start(const ListedGrains& grains, const ReachRule& rule);
  /// A step in which none went further than `way` [m]: true where one may have left its reach.
  bool begin_step(double way)
  {
    forget_wider();
    spare_ -= way + round_off_;
    return !(spare_ > 0.0);
  }
  /// What is to be done about those that have left theirs around where the lists found them,
  /// `listed` [m].
  Answer look(const ListedGrains& grains, const double* listed);
  void forget_wider()
  {
    wider_.clear();
    is_wider_ = false;
  }
  /// Some rank has widened reaches in this step.
  void set_wider() { is_wider_ = true; }
  bool is_wider() const { return is_wider_; }
  /// What another rank says of a ghost.
  void set_reach(int i, double reach)
  {
    if (reach == reach_[i]) return;
    reach_[i] = reach;
    wider_.push_back(i);
  }

  double reach(int i) const { return reach_[i]; }  ///< [m]
  /// Grains of this rank, ghosts too, whose reach got wider in this step.
  const std::vector<int>& wider() const { return wider_; }

 private:
  double least_gap(const ListedGrains& grains, const double* listed) const;

  ReachRule rule_;
  std::vector<double> reach_;
  std::vector<int> wider_;
  bool is_wider_ = false;
  int left_ = 0;            ///< grains that have left the reach they were listed with
  double spare_ = 0.0;      ///< no grain leaves its reach within this way [m]
  double round_off_ = 0.0;  ///< of ways that are added up, each [m]
};

/// How far [m] each grain may be from where the last list of pairs found it: half the `skin` of the
/// host [m], or what the account says.
class GrainReach {
 public:
  GrainReach(double skin, const ReachAccount* account = nullptr)
      : half_skin_(0.5 * skin),
        account_(account)
  {
  }
  double skin() const { return 2.0 * half_skin_; }
  double operator[](int i) const { return account_ ? account_->reach(i) : half_skin_; }
  /// How near [m] to grain i a surface that moves by half a skin must be for a list that is made
  /// while the grain may be anywhere in its reach, and holds until it leaves it.
  double margin(int i) const { return 2.0 * (*this)[i] + half_skin_; }
  /// True where lists that are there must take in more in this step: here, or on some rank.
  bool is_wider_here() const { return account_ && !account_->wider().empty(); }
  bool is_wider() const { return account_ && account_->is_wider(); }
  const std::vector<int>& wider() const { return account_->wider(); }

 private:
  double half_skin_;
  const ReachAccount* account_;
};

}  // namespace encased_column
