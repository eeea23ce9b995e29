#include "analysis/mohr_coulomb.h"

#include "core/input_error.h"

#include <cmath>

namespace encased_column {

StressPoint stress_point(double confining_stress, double deviatoric_stress)
{
  return {confining_stress + deviatoric_stress / 3.0, deviatoric_stress};
}

FailureLine fit_failure_line(const std::vector<StressPoint>& peaks)
{
  double mean_p = 0.0, mean_q = 0.0;
  for (const StressPoint& peak : peaks) {
    mean_p += peak.mean_stress / peaks.size();
    mean_q += peak.deviatoric_stress / peaks.size();
  }
  double spread = 0.0, slope = 0.0;
  for (const StressPoint& peak : peaks) {
    spread += (peak.mean_stress - mean_p) * (peak.mean_stress - mean_p);
    slope += (peak.mean_stress - mean_p) * (peak.deviatoric_stress - mean_q);
  }
  if (!(spread > 1e-12 * mean_p * mean_p))
    throw InputError("a failure line takes peaks at two mean stresses at least, found " +
                     std::to_string(peaks.size()) +
                     " peak(s) at one, add a test at another confining stress");
  slope /= spread;
  return {slope, mean_q - slope * mean_p};
}

Strength strength_of(const FailureLine& line)
{
  if (!(line.slope >= 0.0 && line.slope < 3.0))
    throw InputError("the slope of a failure line must lie from 0 up to 3, found " +
                     in_words(line.slope) + ", check the peaks it was fitted to");
  const double sine = 3.0 * line.slope / (6.0 + line.slope);
  const double cosine = std::sqrt(1.0 - sine * sine);
  return {std::asin(sine), line.intercept * (3.0 - sine) / (6.0 * cosine)};
}

FailureLine failure_line_of(const Strength& strength)
{
  const double sine = std::sin(strength.friction_angle);
  return {6.0 * sine / (3.0 - sine),
          6.0 * strength.cohesion * std::cos(strength.friction_angle) / (3.0 - sine)};
}

}  // namespace encased_column
