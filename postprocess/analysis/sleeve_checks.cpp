#include "analysis/sleeve_checks.h"

#include <algorithm>

namespace encased_column {

std::vector<Check> sleeve_checks(const SleeveRecord& record, const StripLimit& limit)
{
  const auto largest = [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  };
  return {
      {"hoop tension of the sleeve, largest, within the strip test [kN/m]",
       largest(record.hoop_tension_max) / 1e3, limit.tension / 1e3, false},
      {"hoop strain of the sleeve, largest, within the strip test", largest(record.hoop_strain_max),
       limit.strain, false},
  };
}

}  // namespace encased_column
