// SPDX-License-Identifier: GPL-2.0-only
#include "packing/growth_settings.h"

#include "core/input_error.h"

namespace encased_column {

const KeywordTable GrowthSettings::keywords{
    {"from", 1, "-",
     "radius over full radius at the start, 0.01 to 1 (`start_factor` of create_packing)"},
    {"stages", 1, "-", "number of stages in which the radii grow (default 100)"},
    {"relax", 1, "steps", "steps from one stage to the next (default 50)"},
    {"stress", 1, "Pa", "mean stress at full size, which friction gives way to, larger than zero"},
    {"platens", 2, "-", "with `stress`: IDs of the upper and the lower `fix servo/platen`"},
    {"side", 1, "-", "with `stress`: ID of the cylinder or sleeve around the specimen"},
    {"lower_friction", 1, "-",
     "with `stress`: friction after one lowering over before, 0.5 to 0.99 (0.95 where not given)"},
    {"rest", 1, "-",
     "with `stress`: average unbalanced force ratio at its end (1e-2 where not given)"},
    {"until", 1, "-", "with `stress`: `full_size` or `limits` (full_size where not given)"},
};

namespace {

GrowthGoal read_goal(const Options& options)
{
  for (const char* word : {"platens", "side"})
    if (!options.has(word))
      throw InputError("'stress' needs the specimen that bears it, found no '" + std::string(word) +
                       "', write 'platens top bottom side side' with the IDs of its walls");
  GrowthGoal goal;
  goal.stress = options.positive("stress");
  goal.friction_ratio = options.between("lower_friction", 0.5, 0.99, goal.friction_ratio);
  goal.rest = options.positive("rest", goal.rest);
  const bool limits = options.choice("until", {"full_size", "limits"}, "full_size") == "limits";
  goal.until = limits ? GrowthGoal::Until::limits : GrowthGoal::Until::full_size;
  return goal;
}

void refuse_goal_without_stress(const Options& options)
{
  for (const char* word : {"platens", "side", "lower_friction", "rest", "until"})
    if (options.has(word))
      throw InputError("'" + std::string(word) +
                       "' counts with a stress only, found no 'stress', write for example "
                       "'stress 5e3' beside it");
}

}  // namespace

GrowthSettings GrowthSettings::read(const Options& options)
{
  GrowthSettings settings;
  settings.start = options.between("from", 0.01, 1.0);
  settings.stages = options.integer("stages", 1, settings.stages);
  settings.steps_per_stage = options.integer("relax", 1, settings.steps_per_stage);
  if (options.has("stress"))
    settings.goal = read_goal(options);
  else
    refuse_goal_without_stress(options);
  return settings;
}

}  // namespace encased_column
