#include "dynamics/fix_motion.h"

#include "core/constants.h"
#include "core/input_error.h"
#include "host/pair_property.h"
#include "host/rank_sums.h"
#include "host/require_grains.h"

#include "pair_gran.h"

#include <algorithm>

namespace encased_column {

const KeywordTable FixMotion::keywords{
    {"damping", 1, "-", "local damping alpha, 0 to 0.99 (default 0.7)"},
    {"step", 1, "s",
     "`stable`: true masses at the stable step (default); a number: that step, by density scaling"},
    {"safety", 1, "-", "fraction f of the step sqrt(m/k), 0.01 to 1 (default 0.8)"},
    {"every", 1, "steps", "how often stiffness, step and equilibrium are found anew (default 50)"},
    {"free_speed", 1, "m/s",
     "grains that touch nothing fly no faster than this, larger than zero (default: no limit)"},
};

namespace {

/// The step [s] of `step NUMBER`, 0 for `step stable`.
double read_step(const Options& options)
{
  const std::string step = options.word("step", "stable");
  if (step == "stable") return 0.0;
  try {
    return options.positive("step");
  } catch (const InputError&) {
    throw InputError("'step' must be 'stable' or a number larger than zero, found '" + step +
                     "', write 'step stable' or for example 'step 1e-6'");
  }
}

}  // namespace

FixMotion::FixMotion(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : LAMMPS_NS::Fix(lmp, narg, arg)
{
  try {
    const Options options = keywords.read(narg, arg);
    damping_ = options.between("damping", 0.0, 0.99, 0.7);
    mass_scaling.rule.safety = options.between("safety", 0.01, 1.0, 0.8);
    every_ = static_cast<int>(options.integer("every", 1, 50));
    mass_scaling.rule.step = read_step(options);
    read_free_speed(options);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  require_grains(lmp, *this);
  time_integrate = 1;
  time_depend = 1;  // contacts remember step numbers
  restart_global = 1;
  restart_peratom = 1;
  create_attribute = 1;
  vector_flag = 1;
  size_vector = 6;
  global_freq = 1;
  extvector = 0;
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
  for (int i = 0; i < atom->nlocal; ++i) set_arrays(i);
}

FixMotion::~FixMotion()
{
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

void FixMotion::read_free_speed(const Options& options)
{
  if (!options.has("free_speed")) return;
  const double limit = options.positive("free_speed");
  free_speed_square_ = limit * limit;
}

int FixMotion::setmask()
{
  using namespace LAMMPS_NS::FixConst;
  return INITIAL_INTEGRATE | PRE_FORCE | FINAL_INTEGRATE | POST_RUN;
}

void FixMotion::init()
{
  MassScaling::Rule& rule = mass_scaling.rule;
  try {
    auto* pair = dynamic_cast<LAMMPS_NS::PairGran*>(force->pair);
    rule.rolling = pair && pair->contact_match("rolling_friction", "epsd2");
    const PairProperty modulus = read_pair_property(lmp, "contactModulus", 0.0, true);
    const PairProperty ratio = read_pair_property(lmp, "stiffnessRatio", 0.0, true);
    rule.stiffest_material = 0.0;
    const std::vector<int> types = types_that_count();
    for (const int i : types)
      for (const int j : types)
        rule.stiffest_material =
            std::max(rule.stiffest_material,
                     modulus.at(i, j) * decisive_ratio(ratio.at(i, j), rule.rolling));
    if (rule.scales())
      for (const char* name : {"dampingRatioNormal", "dampingRatioShear"}) {
        const PairProperty ratio = read_pair_property(lmp, name, 0.0, false, 0.0);
        for (int i = 1; i <= atom->ntypes; ++i)
          for (int j = 1; j <= atom->ntypes; ++j)
            if (ratio.at(i, j) > 0.0)
              throw InputError(std::string("'") + name +
                               "' must be 0 with density scaling, found " +
                               in_words(ratio.at(i, j)) + ", write 'step stable' or no dashpots");
      }
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  if (!(rule == found_with_)) anew_ = true;
  found_with_ = rule;
  if (rule.scales())
    update->dt = rule.step;
  else if (!anew_ && stable_step_ > 0.0)
    update->dt = stable_step_;
  setting_up_ = true;
  find_onlookers();
}

/// Atom types a grain may meet. With density scaling those of grains: of walls it hears at the
/// first touch. True masses cannot wait for that.
std::vector<int> FixMotion::types_that_count() const
{
  std::vector<double> seen(atom->ntypes, mass_scaling.rule.scales() ? 0.0 : 1.0);
  for (int i = 0; i < atom->nlocal; ++i) seen[atom->type[i] - 1] = 1.0;
  sum_over_ranks(seen.data(), seen.size(), world);
  std::vector<int> types;
  for (int t = 0; t < atom->ntypes; ++t)
    if (seen[t] > 0.0) types.push_back(t + 1);
  return types;
}

// Where a deck's run ends, or a restart file is written, must not change the motion: a set-up alone
// is no reason to look anew. The host sets fixes up in the deck's order, and walls that stand
// behind this fix add their contacts and forces only then: what `run 0` shows is taken here, what
// the first step uses is taken at its start.
void FixMotion::setup(int)
{
  if (anew_) look_anew();
}

void FixMotion::look_anew()
{
  admit_new_grains();
  set_masses();
  compute_unbalanced_ratio();
  set_step();
}

double FixMotion::damping_loss() const
{
  return sum_over_ranks(loss_, world);
}

double FixMotion::compute_vector(int n)
{
  switch (n) {
    case 0:
      return equilibrium_.average;
    case 1:
      return equilibrium_.maximum;
    case 2:
      return stable_step_;
    case 3:
      return largest_factor_;
    case 4:
      return damping_loss();
    default:
      return equilibrium_.contacts;
  }
}

int FixMotion::modify_param(int narg, char** arg)
{
  try {
    const Options options = keywords.read(narg, arg, 0);
    damping_ = options.between("damping", 0.0, 0.99, damping_);
    read_free_speed(options);
    for (const char* fixed : {"step", "safety", "every"})
      if (options.has(fixed))
        throw InputError("'fix_modify " + std::string(id) +
                         "' changes 'damping' and 'free_speed' only, found '" + fixed +
                         "', make a new fix for the rest");
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  return narg;
}

}  // namespace encased_column
