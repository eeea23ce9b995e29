#include "tables/test_density.h"

#include "analysis/relative_density.h"
#include "reading/deck_inputs.h"

namespace encased_column {

namespace {

std::optional<double> number(const CaseRun& run, const std::string& name)
{
  const auto found = run.variables.find(name);
  return found == run.variables.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

TestDensity test_density(const CaseRun& run, const Targets& targets)
{
  const std::vector<DensityPoint> table = targets.densities();
  const std::optional<double> asked = number(run, "relative_density");
  if (asked && *asked >= 0.0) return {*asked, porosity_at(*asked, table)};

  const std::optional<double> porosity = number(run, "porosity");
  const std::optional<double> usual = usual_value(run, "porosity");
  const std::optional<double> sample =
      targets.find("plain_triaxial", "porosity", "prepared sample").laboratory;
  if (!porosity || !usual || !sample) return {};
  const double laboratory = *sample + (*porosity - *usual);
  return {relative_density_at(laboratory, table), laboratory};
}

}  // namespace encased_column
