#pragma once

#include <vector>

namespace encased_column {

/// A state of triaxial stress: p = (sigma1 + 2 sigma3) / 3 and q = sigma1 - sigma3, both [Pa].
/// The study plots a "p-q line" without saying which p it means; through exact Mohr-Coulomb
/// states every convention gives the same friction angle and cohesion.
struct StressPoint {
  double mean_stress;        ///< p [Pa]
  double deviatoric_stress;  ///< q [Pa]
};

/// The state with lateral stress `confining_stress` [Pa] and q = `deviatoric_stress` [Pa].
StressPoint stress_point(double confining_stress, double deviatoric_stress);

/// A failure line q = slope p + intercept.
struct FailureLine {
  double slope;      ///< M [-]
  double intercept;  ///< q at p = 0 [Pa]

  double deviatoric_stress(double mean_stress) const { return slope * mean_stress + intercept; }
};

/// The same line in the words of Mohr and Coulomb.
struct Strength {
  double friction_angle;  ///< apparent, phi [rad]
  double cohesion;        ///< apparent, c [Pa]
};

/// Least-squares line through peak states. Throws InputError with fewer than two different p.
FailureLine fit_failure_line(const std::vector<StressPoint>& peaks);

/// sin(phi) = 3 M / (6 + M) and c = intercept (3 - sin(phi)) / (6 cos(phi)), from
/// sigma1 = Kp sigma3 + 2 c sqrt(Kp), Kp = (1 + sin(phi)) / (1 - sin(phi)), written in p and q.
/// Throws InputError unless the slope is that of a friction angle from 0 up to 90 degrees.
Strength strength_of(const FailureLine& line);

/// The inverse: M = 6 sin(phi) / (3 - sin(phi)), intercept 6 c cos(phi) / (3 - sin(phi)).
FailureLine failure_line_of(const Strength& strength);

}  // namespace encased_column
