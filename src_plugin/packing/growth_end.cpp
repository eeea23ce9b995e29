// SPDX-License-Identifier: GPL-2.0-only
#include "packing/growth_end.h"

#include "core/input_error.h"

#include <cstdio>

namespace encased_column {

namespace {

/// A porosity as soil mechanics writes it.
std::string porosity_in_words(double porosity)
{
  char text[16];
  std::snprintf(text, sizeof(text), "%.4f", porosity);
  return text;
}

}  // namespace

bool GrowthEnd::is_good() const
{
  if (stage != GrowthControl::Stage::ended) return false;
  return goal.until == GrowthGoal::Until::full_size || densest > 0.0;
}

std::string GrowthEnd::in_words() const
{
  using Stage = GrowthControl::Stage;
  using encased_column::in_words;
  const std::string stress = in_words(goal.stress) + " Pa";
  const std::string now = porosity_in_words(porosity), full = porosity_in_words(at_full_size);
  // Without a lowering all friction acts still: where growth came to is the loosest there is.
  const std::string loose = porosity_in_words(loosest > 0.0 ? loosest : porosity);
  const std::string dense = porosity_in_words(densest);
  if (is_good() && goal.until == GrowthGoal::Until::limits)
    return "packing limits at " + stress + ": porosity " + loose + " with all friction, " + dense +
           " without";
  if (is_good())
    return "full size at porosity " + now + ", mean stress " + in_words(found.mean_stress) +
           " Pa, friction times " + in_words(friction_factor) + ", unbalanced force ratio " +
           in_words(found.unbalanced_ratio);
  switch (stage) {
    case Stage::too_dense:
      return "the porosity must be in reach of the gradation at " + stress + ", found " + full +
             " where it packs from " + loose + " with all friction to " + dense +
             " without, write one in between in 'create_packing' or a larger 'stress'";
    case Stage::too_loose:
      return "the porosity must be in reach of the gradation at " + stress + ", found " + full +
             " where the grains bear " + in_words(found.mean_stress) +
             " Pa with all friction, write a smaller one in "
             "'create_packing'; 'until limits' finds the loosest and the densest";
    case Stage::restless:
      return "the grains must come to an unbalanced force ratio of " + in_words(goal.rest) +
             ", found " + in_words(found.unbalanced_ratio) + " after long at porosity " + now +
             ", write a larger 'rest' or 'relax'";
    default:
      return "'until limits' must find the grains pressed before full size, found the porosity " +
             full + " reached, write a smaller one in 'create_packing'";
  }
}

}  // namespace encased_column
