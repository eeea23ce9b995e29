#pragma once

#include "dynamics/stable_step.h"

namespace encased_column {

/// The fix that decides how heavy grains move. With density scaling a grain must be heavy enough
/// for its contacts, and a wall may be far stiffer than the grains: whoever finds a wall contact
/// says so at once.
class InertiaOwner {
 public:
  /// Grain i touches a wall by springs [N/m]: raises its inertial mass where the step asks for it.
  void bear_wall_contact(int i, double normal_stiffness, double shear_stiffness)
  {
    if (scaled_step_ <= 0.0) return;
    const double needed = mass_for_step(
        scaled_step_, wall_stiffness(normal_stiffness, shear_stiffness, rolling_), safety_);
    if (needed > inertia_[i]) make_heavier(i, needed);
  }

 protected:
  virtual ~InertiaOwner() = default;
  /// Gives grain i the inertial mass [kg] and keeps its momentum: kept speed would be energy from
  /// nowhere, thousands of times the grain's own at a wall that is thousands of times stiffer.
  virtual void make_heavier(int i, double inertia) = 0;

  double* inertia_ = nullptr;  ///< inertial mass of each grain [kg]
  double scaled_step_ = 0.0;   ///< with density scaling: the step [s]; 0 without
  double safety_ = 0.8;        ///< fraction of the step sqrt(m/k) [-]
  bool rolling_ = false;       ///< contacts resist rolling
};

}  // namespace encased_column
