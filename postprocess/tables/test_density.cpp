// SPDX-License-Identifier: GPL-2.0-only
#include "tables/test_density.h"

#include "analysis/relative_density.h"
#include "reading/deck_inputs.h"

namespace encased_column {

TestDensity test_density(const CaseRun& run, const Targets& targets)
{
  const std::vector<DensityPoint> table = targets.densities();
  const std::optional<double> asked = run.number("relative_density");
  if (asked && *asked >= 0.0) return {*asked, porosity_at(*asked, table)};

  const std::optional<double> porosity = run.number("porosity");
  const std::optional<double> usual = usual_value(run, "porosity");
  const std::optional<double> sample =
      targets.find("plain_triaxial", "porosity", "prepared sample").laboratory;
  if (!porosity || !usual || !sample) return {};
  const double laboratory = run.number("sample_porosity").value_or(*sample) + (*porosity - *usual);
  return {relative_density_at(laboratory, table), laboratory};
}

}  // namespace encased_column
