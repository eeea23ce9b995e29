// SPDX-License-Identifier: GPL-2.0-only
#include "host/contact_law.h"

#include "core/input_error.h"
#include "host/find_fix.h"

#include "fix_property_global.h"
#include "fix_wall_gran.h"
#include "pair_gran.h"

#include <cmath>

namespace encased_column {

namespace {

/// The host's names of the models that are compiled into it, and ours.
const char* const normal_models[] = {
    "linear",          "hooke",     "hooke/stiffness",     "hooke/hysteresis", "hertz",
    "hertz/stiffness", "edinburgh", "edinburgh/stiffness", "luding",           "thornton_ning"};

template <typename PairOrWall>
std::string normal_model(PairOrWall& contacts)
{
  for (const char* name : normal_models)
    if (contacts.contact_match("normal", name)) return name;
  return "of another kind";
}

template <typename PairOrWall>
bool resists_rolling(PairOrWall& contacts)
{
  return contacts.contact_match("rolling_friction", "epsd2");
}

std::string linear_law(bool rolling)
{
  return std::string("linear tangential history") + (rolling ? " rolling_friction epsd2" : "");
}

}  // namespace

void require_linear_law(LAMMPS_NS::LAMMPS* lmp, const std::string& needs_it)
{
  const std::string rule = needs_it + " needs the linear contact law, found ";
  auto* pair = dynamic_cast<LAMMPS_NS::PairGran*>(lmp->force->pair);
  if (!pair || normal_model(*pair) != "linear")
    throw InputError(
        rule +
        (pair               ? "'pair_style gran model " + normal_model(*pair) + "'"
         : lmp->force->pair ? "'pair_style " + std::string(lmp->force->pair_style) + "'"
                            : "no pair style") +
        ", write 'pair_style gran model " + linear_law(false) + "' and 'pair_coeff * *'");
  const bool rolling = resists_rolling(*pair);
  for (auto* wall : fixes_that_are<LAMMPS_NS::FixWallGran>(lmp)) {
    const std::string model = normal_model(*wall);
    // The stable step allows for walls that resist rolling only where the pairs do too.
    if (model == "linear" && (rolling || !resists_rolling(*wall))) continue;
    throw InputError(rule + "'model " + (model == "linear" ? linear_law(!rolling) : model) +
                     "' in fix " + wall->id + " of style wall/gran, write 'model " +
                     linear_law(rolling) + "' as for the pairs");
  }
}

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
