// SPDX-License-Identifier: GPL-2.0-only
#include "packing/growth_control.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

namespace {

/// Part of the gap to the target that one step closes, as a wall's servo does.
constexpr double gain = 0.8;
/// Part of a step by which the next ones are larger: grains that give way bear less than their
/// contacts promise; and what is left of it where they are not to grow.
constexpr double learning = 0.3, kept = 0.5;
/// Parts of the target: above the first the packing bears it; above the second it was run over,
/// and the grains shrink by the same servo law; below the third it bears nothing.
constexpr double borne = 0.9, run_over = 2.0, nothing = 1e-3;
/// Unbalanced force ratio up to which friction may be lowered: a smaller one lets less of the
/// stress be that of grains in motion, and takes longer.
constexpr double calm = 0.2;
/// Without friction, `limits` presses with so many times the stress: grains slide into their places
/// the sooner the harder they are pressed. What that shortens the specimen is taken back.
constexpr double overpress = 10.0;
/// Below this part of its first value friction is left out altogether.
constexpr double last_friction = 0.02;
/// Looks without a change until it is known that friction is not what holds the grains, and until
/// those that do not come to rest are given up.
constexpr double limit_patience = 20.0, rest_patience = 400.0;

}  // namespace

GrowthControl::GrowthControl(const GrowthGoal& goal, double start, long stages)
    : goal_(goal),
      largest_step_((1.0 - start * start * start) / static_cast<double>(stages)),
      solid_(start * start * start)
{
}

double GrowthControl::radius_factor() const
{
  return solid_ == 1.0 ? 1.0 : std::cbrt(solid_);
}

void GrowthControl::decide(const PackingState& state)
{
  if (stage_ != Stage::grows) return;
  const bool is_full = solid_ == 1.0;
  const bool at_rest = state.unbalanced_ratio <= goal_.rest;
  const bool may_lower = at_rest || (!finds_limits() && state.unbalanced_ratio <= calm);
  const double pressed = state.mean_stress / target();
  if (pressed > run_over || (!is_full && pressed < borne))
    grow(state);
  else if (is_full && pressed <= 1.0)
    come_to_rest(at_rest, pressed);
  else if (friction_ > 0.0 && may_lower)
    lower_friction();
  else if (at_rest)
    wait(Stage::too_dense, limit_patience);
  else
    wait(Stage::restless, rest_patience);
  if (stage_ == Stage::too_dense) note_densest(state);
}

double GrowthControl::target() const
{
  return finds_limits() && friction_ == 0.0 ? overpress * goal_.stress : goal_.stress;
}

void GrowthControl::note_densest(const PackingState& state)
{
  const double excess = finds_limits() ? state.mean_stress - goal_.stress : 0.0;
  densest_ = solid_ * (1.0 - excess / state.bulk_stiffness);
  if (finds_limits()) stage_ = Stage::ended;
}

// Backwards where the target was run over: when loose grains meet all at once, no contact had
// told how stiff they would be.
void GrowthControl::grow(const PackingState& state)
{
  const double gap = target() - state.mean_stress;
  double step = largest_step_;
  if (state.bulk_stiffness > 0.0) {
    const double promised = gain * solid_ * gap / state.bulk_stiffness;
    if (gap < 0.0) even_step_ = 0.0;
    step = std::clamp(promised + even_step_, -largest_step_, largest_step_);
    if (step < largest_step_) even_step_ += learning * std::max(promised, 0.0);
  }
  solid_ = std::min(1.0, solid_ + step);
  waited_ = 0.0;
}

void GrowthControl::lower_friction()
{
  if (loosest_ == 0.0) loosest_ = solid_;
  friction_ *= goal_.friction_ratio;
  if (friction_ < last_friction || finds_limits()) friction_ = 0.0;
  even_step_ *= kept;
  waited_ = 0.0;
}

// Grains that bear nothing may drift for ever: nothing is left to wait for then.
void GrowthControl::come_to_rest(bool at_rest, double pressed)
{
  if (!at_rest && ++waited_ < rest_patience) return;
  stage_ = friction_ == 1.0 && pressed < nothing ? Stage::too_loose : Stage::ended;
}

void GrowthControl::wait(Stage in_vain, double patience)
{
  even_step_ *= kept;
  if (++waited_ >= patience) stage_ = in_vain;
}

std::array<double, GrowthControl::numbers> GrowthControl::state() const
{
  return {solid_, friction_, loosest_, densest_, even_step_, waited_, static_cast<double>(stage_)};
}

void GrowthControl::restore(const std::array<double, numbers>& state)
{
  solid_ = state[0];
  friction_ = state[1];
  loosest_ = state[2];
  densest_ = state[3];
  even_step_ = state[4];
  waited_ = state[5];
  stage_ = static_cast<Stage>(static_cast<int>(state[6]));
}

}  // namespace encased_column
