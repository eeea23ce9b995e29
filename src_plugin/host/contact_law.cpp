#include "host/contact_law.h"

#include "core/input_error.h"
#include "host/contact_observer.h"

#include "fix_wall_gran.h"
#include "pair_gran.h"

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
    // The masses of grains bear walls that resist rolling where the pairs do.
    if (model == "linear" && (rolling || !resists_rolling(*wall))) continue;
    throw InputError(rule + "'model " + (model == "linear" ? linear_law(!rolling) : model) +
                     "' in fix " + wall->id + " of style wall/gran, write 'model " +
                     linear_law(rolling) + "' as for the pairs");
  }
}

}  // namespace encased_column
