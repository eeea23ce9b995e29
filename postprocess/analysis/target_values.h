// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "analysis/inside_specimen.h"
#include "analysis/sleeve_record.h"
#include "analysis/target_condition.h"

#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// The specimen a test is made with, as platen_heights() wants it.
struct SpecimenShape {
  double diameter;  ///< [m]
  double built;     ///< height it was made with [m]
  double height;    ///< at the start of shear [m]
  int moving;       ///< platen that moves

  /// Where the platens stand at `axial_strain` [-].
  PlatenHeights platens(double axial_strain) const
  {
    return platen_heights(built, height, height * (1.0 - axial_strain), moving);
  }
};

/// All that the values of targets.csv are read from; of one test, in order of time. What the test
/// has not written is empty.
struct TargetRecord {
  SpecimenShape shape;
  std::vector<double> displacement;                 ///< of the platens towards one another [m]
  std::vector<double> pressure;                     ///< on the platen that is read [Pa]
  std::optional<double> secant_modulus;             ///< E50 [Pa]
  std::optional<double> peak;                       ///< largest deviatoric stress [Pa]
  std::optional<double> friction_angle;             ///< of all tests of its set [rad]
  std::optional<double> cohesion;                   ///< the same [Pa]
  std::optional<double> grains;                     ///< their number [-]
  std::optional<double> generation_porosity;        ///< [-]
  std::optional<double> porosity;                   ///< at the start of shear [-]
  std::vector<double> expansion_at_the_end;         ///< radial strain at 0.25, 0.5 and 0.75 H [-]
  std::vector<SleeveProfile> profiles;              ///< of the sleeve
  std::vector<SphereSeries> spheres;                ///< from the bottom
  std::vector<ContactSample> contacts;              ///< of the whole specimen
  std::vector<double> strip_strain, strip_tension;  ///< of the sleeve's material [-], [N/m]
};

/// Pressure [Pa] on the platen when the platens have come closer by the condition's displacement;
/// nothing if they did not come so far.
std::optional<double> pressure_at(const TargetRecord& test, const TargetCondition& condition);

/// Mean pressure [Pa] over the last millimetre.
std::optional<double> pressure_at_the_end(const TargetRecord& test, const TargetCondition&);

/// Distance [diameters] of the largest expansion at the end from the upper platen.
std::optional<double> depth_of_peak_expansion(const TargetRecord& test, const TargetCondition&);

/// Distance [diameters] from the upper platen to where the expansion at the end has fallen, below
/// its largest value, to half of it. The foot of the specimen where it does not.
std::optional<double> depth_of_expansion(const TargetRecord& test, const TargetCondition&);

/// Largest expansion [m] along the sleeve at the condition's displacement; nothing if the test did
/// not go so far.
std::optional<double> largest_expansion(const TargetRecord& test, const TargetCondition& condition);

/// Largest contact force [N] of the first and the last sample.
std::optional<double> force_before(const TargetRecord& test, const TargetCondition&);
std::optional<double> force_after(const TargetRecord& test, const TargetCondition&);

/// Porosities [-], overlaps counted once, and coordination number [-] of the measuring spheres at
/// the start: the smallest, the largest, the mean of all.
std::optional<double> lowest_porosity(const TargetRecord& test, const TargetCondition&);
std::optional<double> highest_porosity(const TargetRecord& test, const TargetCondition&);
std::optional<double> mean_coordination(const TargetRecord& test, const TargetCondition&);

/// Tension [N/m] of the sleeve's material at the condition's elongation; nothing beyond its table.
std::optional<double> strip_tension(const TargetRecord& test, const TargetCondition& condition);

/// A kind of value in targets.csv and how it is read from a test, in SI units.
struct TargetValue {
  std::string quantity, condition;  ///< what these columns begin with
  std::optional<double> (*value)(const TargetRecord&, const TargetCondition&);
};

/// All of them.
const std::vector<TargetValue>& target_values();

}  // namespace encased_column
