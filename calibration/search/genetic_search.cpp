// SPDX-License-Identifier: GPL-2.0-only
#include "search/genetic_search.h"

#include "openturns_bridge.h"
#include "space/designs.h"

#include <openturns/Cobyla.hxx>
#include <openturns/OptimizationProblem.hxx>
#include <openturns/Pagmo.hxx>

#include <algorithm>

namespace encased_column {

namespace {

constexpr int population = 100;
constexpr OT::UnsignedInteger generations = 100;

OT::OptimizationProblem problem_of(const OT::Function& objective, int dimensions)
{
  OT::OptimizationProblem problem(objective);
  problem.setBounds(OT::Interval(static_cast<OT::UnsignedInteger>(dimensions)));
  return problem;
}

OT::OptimizationResult evolve(const OT::OptimizationProblem& problem, const char* algorithm,
                              unsigned seed)
{
  const int dimensions = static_cast<int>(problem.getDimension());
  OT::Pagmo search(
      problem, algorithm,
      sample_of(space_filling_design(DesignKind::sobol, population, dimensions, seed)));
  search.setGenerationNumber(generations);
  search.setSeed(seed);
  search.run();
  return search.getResult();
}

/// True if `a` is as good as `b` in both objectives and better in one.
bool is_better(const std::vector<double>& a, const std::vector<double>& b)
{
  return a[0] <= b[0] && a[1] <= b[1] && a != b;
}

}  // namespace

Found genetic_search(const CubeFunction& objective, int dimensions, unsigned seed)
{
  const auto one = [&](const Eigen::VectorXd& point) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1, objective(point));
  };
  const OT::OptimizationProblem problem = problem_of(function_of(dimensions, 1, one), dimensions);
  const OT::Point start = evolve(problem, "sga", seed).getOptimalPoint();
  OT::Cobyla local(problem);
  local.setStartingPoint(start);
  local.setRhoBeg(0.02);  // of the range
  local.setIgnoreFailure(true);
  local.setMaximumEvaluationNumber(400);
  local.run();
  const Eigen::VectorXd evolved = vector_of(start);
  const Eigen::VectorXd polished =
      vector_of(local.getResult().getOptimalPoint()).cwiseMax(0.0).cwiseMin(1.0);
  const Eigen::VectorXd& best = objective(polished) < objective(evolved) ? polished : evolved;
  return {best, {objective(best)}};
}

std::vector<Found> pareto_search(const CubeFunction& first, const CubeFunction& second,
                                 int dimensions, unsigned seed)
{
  const auto both = [&](const Eigen::VectorXd& point) -> Eigen::VectorXd {
    return Eigen::Vector2d(first(point), second(point));
  };
  const OT::OptimizationResult result =
      evolve(problem_of(function_of(dimensions, 2, both), dimensions), "nsga2", seed);
  std::vector<Found> all, front;
  for (OT::UnsignedInteger n = 0; n < result.getFinalPoints().getSize(); ++n) {
    const OT::Point values = result.getFinalValues()[n];
    all.push_back({vector_of(result.getFinalPoints()[n]), {values[0], values[1]}});
  }
  // The fronts that OpenTURNS 1.20 lists are not those of the points it returns.
  for (const Found& one : all)
    if (std::none_of(all.begin(), all.end(),
                     [&](const Found& other) { return is_better(other.values, one.values); }))
      front.push_back(one);
  std::sort(front.begin(), front.end(),
            [](const Found& a, const Found& b) { return a.values < b.values; });
  return front;
}

}  // namespace encased_column
