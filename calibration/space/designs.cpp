// SPDX-License-Identifier: GPL-2.0-only
#include "space/designs.h"

#include "openturns_bridge.h"

#include <openturns/LHSExperiment.hxx>
#include <openturns/LowDiscrepancyExperiment.hxx>
#include <openturns/MonteCarloLHS.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/SobolSequence.hxx>
#include <openturns/SpaceFillingPhiP.hxx>

namespace encased_column {

Eigen::MatrixXd space_filling_design(DesignKind kind, int points, int dimensions, unsigned seed)
{
  OT::RandomGenerator::SetSeed(seed);
  const auto cube = uniform_cube(dimensions, 0.0, 1.0);
  const auto size = static_cast<OT::UnsignedInteger>(points);
  if (kind == DesignKind::sobol) {
    OT::LowDiscrepancyExperiment sequence(OT::SobolSequence(), cube, size);
    sequence.setRandomize(true);
    return matrix_of(sequence.generate());
  }
  constexpr OT::UnsignedInteger tables = 200;  // from which the best is taken
  OT::LHSExperiment experiment(cube, size);
  experiment.setAlwaysShuffle(true);
  return matrix_of(OT::MonteCarloLHS(experiment, tables, OT::SpaceFillingPhiP()).generate());
}

}  // namespace encased_column
