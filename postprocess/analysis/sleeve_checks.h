#pragma once

#include "analysis/run_checks.h"

#include <vector>

namespace encased_column {

/// What a sleeve said while its specimen was sheared; all samples, in order.
struct SleeveRecord {
  std::vector<double> axial_strain;       ///< of the specimen [-]
  std::vector<double> hoop_tension_mean;  ///< weighted by area between the platens [N/m]
  std::vector<double> hoop_tension_max;   ///< of a facet [N/m]
  std::vector<double> hoop_strain_mean;   ///< stretch positive [-]
  std::vector<double> hoop_strain_max;    ///< of a facet [-]
  std::vector<double> friction_force;     ///< grains lay on the sleeve along its axis [N]
  std::vector<double> enclosed_volume;    ///< between the platens [m^3]
};

/// How far a strip of the material was pulled in the laboratory.
struct StripLimit {
  double tension;  ///< [N/m]
  double strain;   ///< [-]
};

/// The largest hoop tension and strain beside those of the strip test, for information: beyond
/// them the linear law of the sleeve is no longer measured.
std::vector<Check> sleeve_checks(const SleeveRecord& record, const StripLimit& limit);

}  // namespace encased_column
