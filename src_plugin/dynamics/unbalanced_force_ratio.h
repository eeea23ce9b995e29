#pragma once

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
  double unbalanced;  ///< of the grains' unbalanced forces [N]
  double grains;
  double contact;  ///< of the contact forces [N]
  double contacts;
};

/// Without a contact force nothing is in equilibrium: the ratios are one then, not zero over zero.
/// Source: Itasca PFC, "mechanical solve ratio-average" and "-maximum".
inline UnbalancedForceRatio compute_unbalanced_ratio(const ForceSums& sums,
                                                     double largest_unbalanced)
{
  if (!(sums.contact > 0.0)) return {1.0, 1.0, sums.contacts};
  const double mean_contact = sums.contact / sums.contacts;
  return {sums.unbalanced / sums.grains / mean_contact, largest_unbalanced / mean_contact,
          sums.contacts};
}

}  // namespace encased_column
