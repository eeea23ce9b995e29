// SPDX-License-Identifier: GPL-2.0-only
// Synthetic recovery: "laboratory" values from a formula with known parameters come back as
// intervals that hold those parameters.
#include "analysis/sampled_curve.h"
#include "config/quantities.h"
#include "runs/run_formula.h"
#include "search/identifiability.h"
#include "stages/calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>
#include <sstream>

using namespace encased_column;

namespace {

const std::vector<Case> rows{{"low", "triaxial_plain", true, {{"sigma3", "50e3"}}, "", ""},
                             {"high", "triaxial_plain", true, {{"sigma3", "150e3"}}, "", ""}};

/// Three parameters; six targets, which tell all of them.
CalibrationConfig recovery_config()
{
  CalibrationConfig config;
  config.name = "recovery";
  config.runs.kind = RunKind::formula;
  config.runs.cases = {"low", "high"};
  config.space = ParameterSpace({{"modulus", "Pa", 40e6, 400e6, true},
                                 {"mu", "-", 0.1, 0.9, false},
                                 {"mu_r", "-", 0.02, 0.8, false}});
  for (const char* quantity : {"secant_modulus", "peak_q", "end_ratio"})
    for (const Case& row : rows)
      config.targets.push_back({quantity, {row.id}, 1.0, 1.0, 1.0, {}, {}, {}, {}});
  config.design.points = 32;
  config.design.repeated = 3;
  config.search.surrogates = {SurrogateKind::polynomial, SurrogateKind::network};
  config.search.folds = 4;
  config.search.rounds = 1;
  config.search.candidates = 3;
  config.search.samples = 1200;
  return config;
}

/// Takes what the formula gives at `truth` with a packing of its own for the laboratory's values.
void set_targets(CalibrationConfig& config, const Eigen::VectorXd& truth, int seed)
{
  for (Target& target : config.targets) {
    PlannedRun run{{0, 0, target.cases.front()}, rows[target.cases.front() == "low" ? 0 : 1], {}};
    run.variables = run.row.variables;
    const std::vector<double> values = config.space.values(truth);
    for (int i = 0; i < config.space.size(); ++i)
      run.variables.emplace_back(config.space[i].name,
                                 std::to_string(values[static_cast<std::size_t>(i)]));
    run.variables.emplace_back("seed", std::to_string(seed));
    target.value = run_formula(run).values.at(target.quantity);
    target.tolerance = 0.01 * target.value;
  }
}

}  // namespace

// Of 20 draws at 95 % each interval of each parameter holds 19 in the mean.
TEST(Recovery, IntervalsHoldTheTruthIn18Of20Draws)
{
  std::mt19937 random(2);
  int held[3] = {0, 0, 0}, all = 0;
  double wide = 0.0;
  for (int draw = 0; draw < 20; ++draw) {
    CalibrationConfig config = recovery_config();
    config.design.seed = static_cast<unsigned>(1 + 1000 * draw);
    Eigen::VectorXd truth(3);
    for (int i = 0; i < 3; ++i) truth[i] = 0.1 + 0.8 * static_cast<double>(random()) / 4294967296.0;
    set_targets(config, truth, 777 + 1000 * draw);
    RunStore store(":memory:");
    std::ostringstream screen;
    Calibration calibration(config, rows, store, screen);
    ASSERT_EQ(calibration.run(*formula_program()), RunsEnd::made);
    const Findings found = calibration.findings();
    bool every = true;
    for (int i = 0; i < 3; ++i) {
      const double low = quantile(found.posterior.points.col(i), 0.025),
                   high = quantile(found.posterior.points.col(i), 0.975);
      const bool inside = low <= truth[i] && truth[i] <= high;
      held[i] += inside;
      every = every && inside;
      wide += (high - low) / 60.0;
    }
    all += every;
  }
  std::cout << "held of 20: modulus " << held[0] << ", mu " << held[1] << ", mu_r " << held[2]
            << ", all three " << all << "; mean width " << wide << " of the range\n";
  for (const int one : held) EXPECT_GE(one, 18);
  EXPECT_GE(all, 18);
  EXPECT_LT(wide, 0.35) << "intervals so wide hold anything";
}

// With E50 alone, stiffness and stiffness ratio cannot be told apart, and the strength not at all.
TEST(Recovery, SaysWhatTheTargetsCannotTell)
{
  CalibrationConfig config = recovery_config();
  config.space = ParameterSpace({{"modulus", "Pa", 40e6, 400e6, true},
                                 {"kappa", "-", 1.0, 9.0, false},
                                 {"mu", "-", 0.1, 0.9, false}});
  config.targets = {{"secant_modulus", {"low"}, 7e6, 0.1e6, 1.0, {}, {}, {}, {}}};
  RunStore store(":memory:");
  std::ostringstream screen;
  Calibration calibration(config, rows, store, screen);
  ASSERT_EQ(calibration.run(*formula_program()), RunsEnd::made);
  const Findings found = calibration.findings();
  std::string sentences;
  for (const std::string& one : found.not_told) sentences += one + "\n";
  EXPECT_NE(sentences.find("The data do not tell mu:"), std::string::npos) << sentences;
  EXPECT_NE(sentences.find("Of modulus and kappa the data tell a combination"), std::string::npos)
      << sentences;
  // E50 = 0.08 E* ... / (0.85 + 0.15 kappa): mu has nothing to do with it.
  const SobolIndices& sobol = found.sensitivities.front().sobol;
  EXPECT_LT(sobol.total[2].value, 0.02);
  EXPECT_GT(sobol.first[0].value, 0.5);
}

TEST(Recovery, MeetsItsTargetsAndEndsBeforeItsBudget)
{
  CalibrationConfig config = recovery_config();
  config.search.rounds = 5;
  set_targets(config, Eigen::Vector3d(0.5, 0.5, 0.5), 5);
  for (Target& target : config.targets) target.tolerance = 0.05 * target.value;
  RunStore store(":memory:");
  std::ostringstream screen;
  Calibration calibration(config, rows, store, screen);
  ASSERT_EQ(calibration.run(*formula_program()), RunsEnd::made);
  const Findings found = calibration.findings();
  EXPECT_TRUE(found.met);
  EXPECT_EQ(found.end, "All targets are met.");
  EXPECT_LT(found.rounds.size(), 5u);
  for (std::size_t n = 0; n < found.outputs.size(); ++n)
    EXPECT_NEAR(found.values[static_cast<Eigen::Index>(n)], found.outputs[n].goal.value,
                found.outputs[n].goal.tolerance)
        << found.outputs[n].goal.name;
  for (const FittedOutput& one : found.fitted.outputs) {
    EXPECT_EQ(one.validations.size(), 2u);
    EXPECT_GT(better_of(one.validations).score, 0.9);
  }
}

// The curve of the formula at known parameters in place of single values: what it tells are
// stiffness and friction.
TEST(Recovery, FitsAWholeCurve)
{
  CalibrationConfig config = recovery_config();
  config.space =
      ParameterSpace({{"modulus", "Pa", 40e6, 400e6, true}, {"mu", "-", 0.1, 0.9, false}});
  const Eigen::Vector2d truth(0.4, 0.6);
  PlannedRun run{{0, 0, "high"}, rows[1], rows[1].variables};
  run.variables.emplace_back("modulus", std::to_string(config.space.value(0, truth[0])));
  run.variables.emplace_back("mu", std::to_string(config.space.value(1, truth[1])));
  run.variables.emplace_back("seed", "99");
  const RunResult laboratory = run_formula(run);
  Target target{"curve", {"high"}, 0.0, 4e3, 2.0, {}, {}, laboratory.strain, laboratory.stress};
  const SampledCurve curve(laboratory.strain, laboratory.stress);
  for (const double strain : {0.01, 0.02, 0.04, 0.08}) {
    target.strain.push_back(strain);
    target.stress.push_back(curve.value(strain));
  }
  config.targets = {target};
  RunStore store(":memory:");
  std::ostringstream screen;
  Calibration calibration(config, rows, store, screen);
  ASSERT_EQ(calibration.run(*formula_program()), RunsEnd::made);
  const Findings found = calibration.findings();
  ASSERT_EQ(found.outputs.size(), 4u);
  double weight = 0.0;
  for (std::size_t n = 0; n < 4; ++n) {
    weight += found.outputs[n].goal.weight;
    EXPECT_EQ(found.outputs[n].goal.value, target.stress[n]);
    EXPECT_NEAR(found.values[static_cast<Eigen::Index>(n)], target.stress[n],
                0.05 * target.stress[n]);
  }
  EXPECT_DOUBLE_EQ(weight, 2.0);
  for (int i = 0; i < 2; ++i) {
    EXPECT_LT(quantile(found.posterior.points.col(i), 0.025), truth[i]);
    EXPECT_GT(quantile(found.posterior.points.col(i), 0.975), truth[i]);
    EXPECT_EQ(knowledge_of(found.posterior.points.col(i)), Knowledge::told);
  }
}

TEST(Recovery, RefusesABudgetThatTheDesignAloneExceeds)
{
  CalibrationConfig config = recovery_config();
  config.budget = 75;
  RunStore store(":memory:");
  std::ostringstream screen;
  Calibration calibration(config, rows, store, screen);
  try {
    calibration.run(*formula_program());
    FAIL();
  } catch (const std::exception& problem) {
    EXPECT_STREQ(
        problem.what(),
        "'budget' must leave room for the 76 runs of the design, found 75, write a larger one "
        "or fewer 'points'");
  }
}
