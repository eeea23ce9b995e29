// SPDX-License-Identifier: GPL-2.0-only
#include "dynamics/motion_settings.h"

#include "core/input_error.h"

namespace encased_column {

const KeywordTable MotionSettings::keywords{
    {"damping", 1, "-", "local damping alpha, 0 to 0.99 (default 0.7)"},
    {"step", 1, "s",
     "`stable` (default): true masses at the stable step; a number: that step, by density scaling"},
    {"safety", 1, "-", "fraction f of the step sqrt(m/k), 0.01 to 1 (default 0.8)"},
    {"every", 1, "steps", "how often stiffness, step and equilibrium are computed (default 50)"},
    {"free_speed", 1, "m/s",
     "grains that touch nothing fly no faster than this, larger than zero (default: no limit)"},
};

namespace {

/// The step [s] of `step NUMBER`, 0 for `step stable`.
double read_step(const Options& options)
{
  const std::string step = options.word("step", "stable");
  if (step == "stable") return 0.0;
  try {
    return options.positive("step");
  } catch (const InputError&) {
    throw InputError("'step' must be 'stable' or a number larger than zero, found '" + step +
                     "', write 'step stable' or for example 'step 1e-6'");
  }
}

}  // namespace

MotionSettings MotionSettings::read(const Options& options)
{
  MotionSettings settings;
  settings.read_changeable(options);
  settings.safety = options.between("safety", 0.01, 1.0, settings.safety);
  settings.every = static_cast<int>(options.integer("every", 1, settings.every));
  settings.step = read_step(options);
  return settings;
}

void MotionSettings::modify(const Options& options, const char* id)
{
  read_changeable(options);
  for (const char* fixed : {"step", "safety", "every"})
    if (options.has(fixed))
      throw InputError("'fix_modify " + std::string(id) +
                       "' changes 'damping' and 'free_speed' only, found '" + fixed +
                       "', make a new fix for the rest");
}

void MotionSettings::read_changeable(const Options& options)
{
  damping = options.between("damping", 0.0, 0.99, damping);
  if (options.has("free_speed")) free_speed = options.positive("free_speed");
}

}  // namespace encased_column
