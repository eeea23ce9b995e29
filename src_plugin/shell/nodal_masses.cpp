// SPDX-License-Identifier: GPL-2.0-only
#include "shell/nodal_masses.h"

namespace encased_column {

namespace {

constexpr int bounds_apart = 20;  ///< times `every`, between two bounds of the facets' stiffness

}  // namespace

void NodalMasses::start(const SleeveStep& step, bool at_set_up, bool rigid, int nodes)
{
  updates_ =
      !rigid && (step_length_ != step.length || (!at_set_up && step.number % rule_.every == 0));
  if (rigid) step_length_ = 0.0;
  if (updates_) contact_bound_.assign(nodes, {0.0, 0.0});
}

/// True where the bound is that of these facets alone and must be summed.
bool NodalMasses::find_facet_bound(const ShellModel& model, int first, int last,
                                   const SleeveStep& step)
{
  if (!facet_bound_.empty() && step.number % (bounds_apart * rule_.every) != 0) return false;
  facet_bound_.assign(model.nodes(), {0.0, 0.0});
  model.add_stiffness(first, last, facet_bound_);
  return true;
}

double NodalMasses::update(ShellModel& model, const SleeveStep& step)
{
  for (int i = 0; i < model.nodes(); ++i) {
    contact_bound_[i].translation += facet_bound_[i].translation;
    contact_bound_[i].rotation += facet_bound_[i].rotation;
  }
  const bool from_true_masses = step_length_ != step.length;
  step_length_ = step.length;
  if (rule_.scaled) {
    const double taken =
        model.scale_masses(contact_bound_, step.length, rule_.safety, from_true_masses);
    factor_ = model.mass_factor();
    return taken;
  }
  const double stable = model.stable_step(contact_bound_, rule_.safety);
  if (step.length > stable)
    throw InputError("the step of " + in_words(step.length) +
                     " s is longer than the sleeve's stable " + in_words(stable) +
                     " s, write a shorter step or 'mass_scaling yes'");
  return 0.0;
}

// A sleeve that was never released has no bounds yet: its release must find them, not take zeros.
void NodalMasses::save(std::vector<double>& numbers) const
{
  numbers.insert(numbers.end(), {step_length_, factor_, facet_bound_.empty() ? 0.0 : 1.0});
}

void NodalMasses::restore(NumberRow& numbers)
{
  step_length_ = numbers.take();
  factor_ = numbers.take();
  bounds_are_saved_ = numbers.take() != 0.0;
}

void NodalMasses::save_bounds(std::vector<double>& numbers) const
{
  for (const StiffnessBound& bound : facet_bound_)
    numbers.insert(numbers.end(), {bound.translation, bound.rotation});
}

void NodalMasses::restore_bounds(NumberRow& numbers, int nodes)
{
  facet_bound_.resize(bounds_are_saved_ ? nodes : 0);
  for (StiffnessBound& bound : facet_bound_) {
    bound.translation = numbers.take();
    bound.rotation = numbers.take();
  }
}

}  // namespace encased_column
