#include "host/pair_property.h"

#include "core/input_error.h"

#include "fix_property_global.h"

#include <cmath>

namespace encased_column {

PairProperty read_pair_property(LAMMPS_NS::LAMMPS* lmp, const std::string& name, double low,
                                bool above, std::optional<double> otherwise)
{
  const int types = lmp->atom->ntypes;
  LAMMPS_NS::Fix* fix = lmp->modify->find_fix_property(
      name.c_str(), "property/global", "peratomtypepair", types, types, "linear", false);
  if (!fix) {
    if (otherwise) return PairProperty(types, *otherwise);
    throw InputError("the linear contact law needs '" + name +
                     "', found none for pairs of types, write 'fix ID all property/global " + name +
                     " peratomtypepair " + std::to_string(types) + " ...' with " +
                     std::to_string(types * types) + " values");
  }
  PairProperty property(types, 0.0);
  for (int i = 1; i <= types; ++i)
    for (int j = 1; j <= types; ++j) {
      const double value = fix->compute_array(i - 1, j - 1);
      if (!std::isfinite(value) || value < low || (above && value == low))
        throw InputError("'" + name + "' must be " + (above ? "larger than " : "at least ") +
                         in_words(low) + " for every pair of types, found " + in_words(value) +
                         " for types " + std::to_string(i) + " and " + std::to_string(j) +
                         ", write for example " +
                         in_words(std::isfinite(value) && -value > low ? -value : low + 1.0) +
                         " there in 'fix " + fix->id + "'");
      property.at(i, j) = value;
    }
  // The host refuses this for `peratomtypepair`, but hands out a `matrix` of that name unchecked.
  for (int i = 1; i <= types; ++i)
    for (int j = 1; j < i; ++j)
      if (property.at(i, j) != property.at(j, i))
        throw InputError("'" + name + "' must be symmetric, found " + in_words(property.at(i, j)) +
                         " for types " + std::to_string(i) + " and " + std::to_string(j) + " and " +
                         in_words(property.at(j, i)) +
                         " the other way round, write one value for both in 'fix " + fix->id + "'");
  return property;
}

}  // namespace encased_column
