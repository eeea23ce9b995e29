// SPDX-License-Identifier: GPL-2.0-only
// The account that a step of the sleeve gives of its energy closes.
#include "shell/pressure_load.h"
#include "sleeve_cases.h"

#include <gtest/gtest.h>

using namespace encased_column;

namespace {

/// A tube under pressure: the lower end held, the upper one moved along at a speed that changes
/// every step, some nodes held across the axis, the rest free.
class WorkedTube {
 public:
  explicit WorkedTube(double alpha) : model_(short_tube()), alpha_(alpha)
  {
    for (int i = 0; i < 16; ++i) model_.support().push_back(clamped(i));
    for (int i = 20; i < 24; ++i) model_.support().push_back(held_across(i, Vec3::UnitZ()));
    first_moved_ = model_.support().size();
    for (int i = model_.nodes() - 16; i < model_.nodes(); ++i) model_.support().push_back(held(i));
  }

  double stable_step() const
  {
    std::vector<StiffnessBound> bound(model_.nodes(), {0.0, 0.0});
    model_.add_stiffness(0, model_.facets(), bound);
    return model_.stable_step(bound, 1.0);
  }

  /// One step from time `t` [s]; books energies and works.
  void step(double t, double dt)
  {
    model_.clear_loads();
    stored_before = stored;
    stored = model_.add_internal_loads(0, model_.facets());
    const std::vector<Vec3> internal = model_.load();
    add_pressure(model_.facet(), model_.position(), 0, model_.facets(), 2e4, {}, model_.external());
    for (int i = 0; i < model_.nodes(); ++i) model_.force(i) += model_.external()[i];
    for (std::size_t n = first_moved_; n < model_.support().size(); ++n)
      model_.support()[n].velocity = Vec3(0.0, 0.05 * std::sin(3e4 * t), -0.2 * std::sin(2e4 * t));

    const std::vector<Vec3> v = model_.velocity(), w = model_.angular_velocity();
    kinetic_before = model_.kinetic_energy();
    work = model_.advance(dt, alpha_);
    kinetic = model_.kinetic_energy();
    internal_work = 0.0;
    for (int i = 0; i < model_.nodes(); ++i)
      internal_work += 0.5 * dt *
                       (internal[i].dot(v[i] + model_.velocity()[i]) +
                        internal[model_.nodes() + i].dot(w[i] + model_.angular_velocity()[i]));
    total_work += work.external + work.supports - work.damping;
    throughput += std::abs(work.external) + std::abs(work.supports) + std::abs(work.damping);
  }

  StepWork work;
  double stored = 0.0, stored_before = 0.0, kinetic = 0.0, kinetic_before = 0.0;
  double internal_work = 0.0, total_work = 0.0, throughput = 0.0;

 private:
  ShellModel model_;
  double alpha_;
  std::size_t first_moved_;
};

/// What does not close of the energy over three milliseconds, over the energy that passed through.
double closing_error(double alpha, double factor)
{
  WorkedTube tube(alpha);
  const double duration = 3e-3;
  const long steps = std::lround(duration / (factor * tube.stable_step()));
  const double dt = duration / static_cast<double>(steps);
  for (long i = 0; i < steps; ++i) tube.step(i * dt, dt);
  // Velocities are known half way between positions: the stored energy there is the mean.
  const double kinetic = tube.kinetic, work = tube.total_work, throughput = tube.throughput;
  tube.step(duration, dt);
  const double gain = kinetic + 0.5 * (tube.stored_before + tube.stored);
  return std::abs(gain - work) / throughput;
}

}  // namespace

TEST(StepWork, KineticEnergyOfEveryStepIsTheWorkOfAllForcesToRoundOff)
{
  for (const double alpha : {0.0, 0.7}) {
    WorkedTube tube(alpha);
    const double dt = 0.5 * tube.stable_step();
    for (int i = 0; i < 500; ++i) {
      tube.step(i * dt, dt);
      const double gain = tube.kinetic - tube.kinetic_before;
      const double expected =
          tube.internal_work + tube.work.external + tube.work.supports - tube.work.damping;
      const double size = tube.kinetic + std::abs(tube.internal_work) +
                          std::abs(tube.work.external) + std::abs(tube.work.supports);
      EXPECT_NEAR(gain, expected, 1e-12 * size) << "alpha " << alpha << " step " << i;
    }
  }
}

TEST(StepWork, EnergyClosesToTheSquareOfTheStep)
{
  for (const double alpha : {0.0, 0.3}) {
    const double coarse = closing_error(alpha, 0.4), fine = closing_error(alpha, 0.1);
    EXPECT_LT(coarse, 0.02) << "alpha " << alpha;
    EXPECT_LT(fine, coarse / 8.0) << "alpha " << alpha;
  }
}

TEST(StepWork, DampingNeverGivesEnergyToABodyThatStartsFromRest)
{
  WorkedTube tube(0.7);
  const double dt = 0.5 * tube.stable_step();
  double damping = 0.0;
  for (int i = 0; i < 1000; ++i) {
    tube.step(i * dt, dt);
    damping += tube.work.damping;
  }
  EXPECT_GT(damping, 0.0);
}
