#pragma once

#include "core/vec3.h"

#include <algorithm>

namespace encased_column {

/// How far the grains are from equilibrium; see fix_motion.md. Unbalanced forces are those that
/// contacts and weight leave over on a grain.
struct UnbalancedForceRatio {
  double average = 0.0;   ///< mean unbalanced over mean contact force [-]
  double maximum = 0.0;   ///< largest unbalanced over mean contact force [-]
  double contacts = 0.0;  ///< number of contacts [-]
};

/// Sums over all grains and contacts.
struct ForceSums {
  double unbalanced = 0.0;  ///< of the grains' unbalanced forces [N]
  double grains = 0.0;
  double contact = 0.0;  ///< of the contact forces [N]
  double contacts = 0.0;

  /// `share` as the rank counts the contact.
  void add_contact(double size, double share)
  {
    contact += share * size;
    contacts += share;
  }
  /// Adds the unbalanced forces of `count` grains, of those that `mask` and `group` pick out, and
  /// returns the largest [N].
  double add_grains(const double* force, const int* mask, int group, int count)
  {
    double largest = 0.0;
    for (int i = 0; i < count; ++i) {
      if (!(mask[i] & group)) continue;
      const double size = as_vec3(force + 3 * i).norm();
      unbalanced += size;
      grains += 1.0;
      largest = std::max(largest, size);
    }
    return largest;
  }
};

/// Source: Itasca PFC, "mechanical solve ratio-average" and "-maximum". Where contacts bear less
/// than what is unbalanced, grains fly: the ratios count against the unbalanced force then, so that
/// the average is one, as without any contact force, and not a number over nothing.
inline UnbalancedForceRatio compute_unbalanced_ratio(const ForceSums& sums,
                                                     double largest_unbalanced)
{
  if (!(sums.contact > 0.0)) return {1.0, 1.0, sums.contacts};
  const double mean_contact = sums.contact / sums.contacts;
  const double mean_unbalanced = sums.grains > 0.0 ? sums.unbalanced / sums.grains : 0.0;
  const double size = std::max(mean_contact, mean_unbalanced);
  return {mean_unbalanced / size, largest_unbalanced / size, sums.contacts};
}

}  // namespace encased_column
