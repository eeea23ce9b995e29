// SPDX-License-Identifier: GPL-2.0-only
#include "shell/fix_mesh_surface_shell.h"

#include "host/messages.h"
#include "host/restart_block.h"
#include "shell/sleeve_input.h"

#include "pair_gran.h"

#include <algorithm>
#include <cstring>

namespace encased_column {

const KeywordTable FixMeshSurfaceShell::keywords{sleeve_keywords(), {}};

namespace {

const char* const deck_style = "mesh/surface/shell";

}  // namespace

FixMeshSurfaceShell::FixMeshSurfaceShell(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : ContactMemoryFix(lmp, narg, arg),
      platens_(lmp),
      context_(lmp, ContactKind::sleeve)
{
  try {
    on_fix_line_ = keywords.read(narg, arg);
    type_ = static_cast<int>(on_fix_line_.integer("type", 1));
    if (type_ > atom->ntypes)
      throw InputError("'type' must be one of the " + std::to_string(atom->ntypes) +
                       " atom types, found " + std::to_string(type_) +
                       ", write a smaller one or make room in 'create_box'");
    platens_.read(on_fix_line_);
    const ShellConstants constants = read_shell_constants(on_fix_line_);
    sleeve_ =
        std::make_unique<Sleeve>(read_sleeve_mesh(on_fix_line_), constants,
                                 read_nodal_mass_rule(on_fix_line_), Rank{comm->me, comm->nprocs});
    sleeve_->set_control(read_sleeve_control(on_fix_line_, {}), update->ntimestep);
    read_pressure(on_fix_line_);
    say_understood(lmp, *this, on_fix_line_, "fix", deck_style);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  // The host takes whatever is called mesh/surface... for a mesh of its own.
  delete[] style;
  style = std::strcpy(new char[sizeof("sleeve")], "sleeve");
  restart_global = 1;
  vector_flag = 1;
  size_vector = numbers;
  global_freq = 1;
  extvector = 0;
}

void FixMeshSurfaceShell::read_pressure(const Options& options)
{
  if (options.has("pressure"))
    sleeve_->set_pressure(options.number("pressure"), options.integer("ramp", 1, 1),
                          update->ntimestep);
  const long reached = update->ntimestep + sleeve_->ramp_left(update->ntimestep);
  options.assume("pressure", sleeve_->pressure(reached));
}

int FixMeshSurfaceShell::modify_param(int narg, char** arg)
{
  try {
    const Options options = keywords.read(narg, arg, 0);
    require_changeable(options);
    sleeve_->set_control(read_sleeve_control(options, sleeve_->control()), update->ntimestep);
    read_pressure(options);
    say_understood(lmp, *this, options, "fix_modify", deck_style);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
  return narg;
}

int FixMeshSurfaceShell::setmask()
{
  using namespace LAMMPS_NS::FixConst;
  return INITIAL_INTEGRATE | POST_FORCE | FINAL_INTEGRATE;
}

void FixMeshSurfaceShell::init()
{
  auto* pair = dynamic_cast<LAMMPS_NS::PairGran*>(force->pair);
  rolling_ = pair && pair->contact_match("rolling_friction", "epsd2");
  try {
    require_open_box(lmp, deck_style, "xy");
    context_.open(rolling_);
    platens_.find();
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

// Set-up repeats the forces of the step before: what contacts remember stays as it is.
void FixMeshSurfaceShell::setup(int)
{
  take_loads(true);
  finish_loads();
  sleeve_->find_reactions();
}

void FixMeshSurfaceShell::initial_integrate(int)
{
  const Platens platens = platens_.now();
  sleeve_->advance(update->dt, {platens.top->speed(), platens.bottom->speed()});
}

void FixMeshSurfaceShell::take_loads(bool at_set_up)
{
  sleeve_->start_loads(step_now(), window(), at_set_up);
  context_.ask_observers();
  const bool anew = neighbor->ago == 0 || sleeve_->needs_list();
  if (anew || context_.reach().is_wider())
    remember(sleeve_->list_grains(atom->nlocal ? atom->x[0] : nullptr, atom->radius, atom->nlocal,
                                  context_.reach(), anew, AllRanks{world}));
  if (!sleeve_->has_grains_near()) return;
  if (rolling_)
    press(rolling_batch_, !at_set_up);
  else
    press(batch_, !at_set_up);
}

template <typename Batch>
void FixMeshSurfaceShell::press(Batch& batch, bool advance_memory)
{
  static_assert(Batch::size >= SleeveContacts::in_block);
  const GrainArrays grains(atom);
  const auto law = [&](const SleeveContact* contacts, int count, SleeveReaction* reactions) {
    for (int n = 0; n < count; ++n) {
      const SleeveContact& contact = contacts[n];
      const int i = contact.grain;
      const double radius = grains.radius[i];
      batch.add(i, -1, 1.0, stiffened(context_.material(grains.type[i], type_), contact.merged),
                radius * contact.merged.normal,
                {radius, as_vec3(grains.v + 3 * i), as_vec3(grains.omega + 3 * i)}, contact.body(),
                context_.has_dashpots() ? grains.mass[i] : 0.0, contact_memory(contact.n),
                contact.merged.overlap);
    }
    context_.resolve(batch, advance_memory);
    for (int n = 0; n < count; ++n) {
      const int i = batch.i(n);
      const ContactStiffness stiffness = batch.stiffness(n);
      context_.raise_mass_for_contact(i, stiffness);
      as_vec3(grains.force + 3 * i) += batch.force(n);
      as_vec3(grains.moment + 3 * i) += batch.moment_i(n);
      reactions[n] = {batch.normal_force(n), batch.force(n), batch.moment_on_wall(n),
                      std::max(stiffness.normal, stiffness.shear)};
    }
    batch.clear();
  };
  if (const auto behind = sleeve_->press_grains(GrainsOfGroup{*this, grains}, law))
    stop_from_one_rank(
        lmp, sleeve_->sentence_of(*behind, atom->tag[behind->grain], id, update->ntimestep));
}

void FixMeshSurfaceShell::finish_loads()
{
  try {
    sleeve_->finish_loads(step_now(), AllRanks{world});
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

void FixMeshSurfaceShell::final_integrate()
{
  finish_loads();
  const long step = update->ntimestep;
  if (!sleeve_->is_time_to_check(step)) return;
  if (const auto fault = sleeve_->fault(step))
    stop_from_one_rank(lmp, "at step " + std::to_string(step) + " " + *fault);
  share_memory();
  for (const std::string& sentence :
       sleeve_->warnings(window(), id, {platens_.id(true), platens_.id(false)}, step))
    if (comm->me == 0) error->warning(FLERR, sentence.c_str());
}

// Each number by its own way: some add up over the ranks.
double FixMeshSurfaceShell::compute_vector(int n)
{
  using Fix = FixMeshSurfaceShell;
  static constexpr double (*number[numbers])(Fix&) = {
      [](Fix& f) { return f.pressure_now(); },
      [](Fix& f) { return f.summary().hoop_tension; },
      [](Fix& f) { return f.summary().hoop_tension_max; },
      [](Fix& f) { return f.summary().hoop_strain; },
      [](Fix& f) { return f.summary().hoop_strain_max; },
      [](Fix& f) { return f.axial_force(true); },
      [](Fix& f) { return f.axial_force(false); },
      [](Fix& f) { return f.friction_force(); },
      [](Fix& f) { return f.enclosed_volume(f.window().low, f.window().high); },
      [](Fix& f) { return f.stored_energy(); },
      [](Fix& f) { return f.kinetic_energy(); },
      [](Fix& f) { return f.work(); },
      [](Fix& f) { return f.damping_loss(); },
      [](Fix& f) { return f.sleeve_->mass_factor(); },
      [](Fix& f) { return static_cast<double>(f.sleeve_->ramp_left(f.update->ntimestep)); },
      [](Fix& f) { return f.summary().plastic_hoop_strain_max; },
      [](Fix& f) { return f.summary().damage_max; },
      [](Fix& f) { return f.yielding_loss(); },
  };
  return number[n](*this);
}

void FixMeshSurfaceShell::write_restart(FILE* file)
{
  const double pressure_work = sum_over_ranks(sleeve_->pressure_work(), world);
  const double dissipated = yielding_loss();
  share_memory();
  if (comm->me == 0) write_block(file, sleeve_->state(pressure_work, dissipated));
}

// The sleeve goes on as it was, but for what the fix line says.
void FixMeshSurfaceShell::restart(char* buffer)
{
  try {
    RestartBlock block(buffer);
    std::vector<double> state(block.left());
    block.take(state.data(), state.size());
    sleeve_->restore(state);
    read_pressure(on_fix_line_);
    say_understood(lmp, *this, on_fix_line_, "fix", deck_style);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

}  // namespace encased_column
