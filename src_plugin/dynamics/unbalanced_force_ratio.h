// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace encased_column {

/// How far the grains are from equilibrium; see fix_motion.md. Unbalanced forces are those that
/// contacts and weight leave over on a grain.
struct UnbalancedForceRatio {
  double average = 0.0;   ///< mean unbalanced over mean contact force [-]
  double maximum = 0.0;   ///< largest unbalanced over mean contact force [-]
  double contacts = 0.0;  ///< number of contacts [-]
  double bearing = 0.0;   ///< as `average`; grains that bear no load count as balanced [-]
};

/// A grain bears load when the forces at its contacts add up to more than this many of its weights.
/// Less is what a grain feels that lies, rolls or falls in a void of the others, with a few as
/// small as itself on top of it; without weight, every grain that touches something bears.
constexpr double weights_of_a_bearing_grain = 10.0;

/// Sums over all grains and contacts, and nothing else: ranks add them up as a row of numbers.
struct ForceSums {
  double unbalanced = 0.0;  ///< of the grains' unbalanced forces [N]
  double grains = 0.0;
  double unbalanced_bearing = 0.0;  ///< as `unbalanced`, of the grains that bear load [N]
  double contact = 0.0;             ///< of the contact forces [N]
  double contacts = 0.0;

  bool is_finite() const { return std::isfinite(unbalanced + contact); }
  /// Grains as add_grains() sees them: unbalanced `force` [N] in triples, `load` [N], the sum of
  /// the sizes of all contact forces on the grain, and `mass` [kg] under an acceleration `gravity`
  /// [m/s^2]; those count that `mask` and `group` pick out.
  struct Grains {
    const double* force;
    const double* load;
    const double* mass;
    double gravity;
    const int* mask;
    int group, count;
  };
  /// Adds the unbalanced forces and returns the largest [N].
  double add_grains(const Grains& g)
  {
    double largest = 0.0;
    for (int i = 0; i < g.count; ++i) {
      if (!(g.mask[i] & g.group)) continue;
      const double size = as_vec3(g.force + 3 * i).norm();
      unbalanced += size;
      grains += 1.0;
      largest = std::max(largest, size);
      if (g.load[i] > weights_of_a_bearing_grain * g.mass[i] * g.gravity)
        unbalanced_bearing += size;
    }
    return largest;
  }
};

/// What contacts press on the grains of a rank.
class GrainLoads {
 public:
  /// Before the contacts of `grains` grains are added.
  void clear(int grains)
  {
    sums_ = {};
    grains_ = grains;
    load_ = std::vector<double>();
  }
  /// A contact force of a `size` [N] between grain i and grain j, or a wall or a grain of another
  /// rank where `j` is none of the grains; `share` as the rank counts the contact.
  void add(int i, int j, double size, double share)
  {
    if (load_.empty()) load_.resize(grains_, 0.0);
    sums_.contact += share * size;
    sums_.contacts += share;
    load_[i] += size;
    if (j >= 0 && j < static_cast<int>(load_.size())) load_[j] += size;
  }
  const ForceSums& sums() const { return sums_; }
  /// Of each of `grains` grains [N]; zero of those made since the contacts were added.
  const double* load(int grains)
  {
    load_.resize(grains, 0.0);
    return load_.data();
  }

 private:
  ForceSums sums_;
  int grains_ = 0;
  std::vector<double> load_;  ///< empty until there is a contact
};

/// Source: Itasca PFC, "mechanical solve ratio-average" and "-maximum". Where contacts bear less
/// than what is unbalanced, grains fly: the ratios count against the unbalanced force then, so that
/// the average is one, as without any contact force, and not a number over nothing.
inline UnbalancedForceRatio compute_unbalanced_ratio(const ForceSums& sums,
                                                     double largest_unbalanced)
{
  if (!(sums.contact > 0.0)) return {1.0, 1.0, sums.contacts, 1.0};
  const auto mean = [](double sum, double number) { return number > 0.0 ? sum / number : 0.0; };
  const double mean_contact = sums.contact / sums.contacts;
  const double mean_unbalanced = mean(sums.unbalanced, sums.grains);
  const double mean_bearing = mean(sums.unbalanced_bearing, sums.grains);
  const double size = std::max(mean_contact, mean_unbalanced);
  return {mean_unbalanced / size, largest_unbalanced / size, sums.contacts,
          mean_bearing / std::max(mean_contact, mean_bearing)};
}

}  // namespace encased_column
