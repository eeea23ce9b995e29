// The sleeve in restart files: its whole state, so that a run goes on bit by bit.
#include "shell/fix_mesh_surface_shell.h"

#include "host/rank_sums.h"
#include "host/restart_block.h"

namespace encased_column {

namespace {

void put(std::vector<double>& to, const Vec3& v)
{
  to.insert(to.end(), v.data(), v.data() + 3);
}

Vec3 take(RestartBlock& from)
{
  Vec3 v;
  from.take(v.data(), 3);
  return v;
}

}  // namespace

void FixMeshSurfaceShell::write_restart(FILE* file)
{
  const double pressure_work = sum_over_ranks(pressure_work_, world);
  if (comm->me != 0) return;
  const int nodes = model_->nodes();
  std::vector<double> numbers{static_cast<double>(nodes),
                              pressure_work,
                              support_work_,
                              damping_loss_,
                              weighed_step_,
                              mass_factor_,
                              facet_bound_.empty() ? 0.0 : 1.0};
  for (const double number : pressure_.state()) numbers.push_back(number);
  for (int i = 0; i < nodes; ++i) {
    put(numbers, model_->position()[i]);
    for (int a = 0; a < 4; ++a) numbers.push_back(model_->rotation()[i].coeffs()(a));
    put(numbers, model_->velocity()[i]);
    put(numbers, model_->angular_velocity()[i]);
    numbers.push_back(model_->mass()[i]);
    numbers.push_back(model_->inertia()[i]);
  }
  for (const StiffnessBound& bound : facet_bound_) {
    numbers.push_back(bound.translation);
    numbers.push_back(bound.rotation);
  }
  write_block(file, numbers);
}

// The sleeve goes on as it was, but for what the fix line says.
void FixMeshSurfaceShell::restart(char* buffer)
{
  try {
    RestartBlock block(buffer);
    restore(block);
    read_pressure(on_fix_line_);
  } catch (const InputError& problem) {
    error->fix_error(FLERR, this, problem.what());
  }
}

void FixMeshSurfaceShell::restore(RestartBlock& block)
{
  const int nodes = model_->nodes();
  if (const double saved = block.take(); saved != nodes)
    throw InputError("the sleeve of the restart file has " + in_words(saved) + " nodes, this one " +
                     std::to_string(nodes) + ", give the mesh it was made with");
  const double pressure_work = block.take();
  pressure_work_ = comm->me == 0 ? pressure_work : 0.0;
  support_work_ = block.take();
  damping_loss_ = block.take();
  weighed_step_ = block.take();
  mass_factor_ = block.take();
  // A sleeve that was never released has none yet: its release must find them, not take zeros.
  const bool bounds_are_known = block.take() != 0.0;
  std::array<double, PressureRamp::numbers> ramp;
  block.take(ramp.data(), ramp.size());
  pressure_.restore(ramp);
  std::vector<Vec3> position(nodes), velocity(nodes), spin(nodes);
  std::vector<Quaternion> rotation(nodes);
  std::vector<double> mass(nodes), inertia(nodes);
  for (int i = 0; i < nodes; ++i) {
    position[i] = take(block);
    block.take(rotation[i].coeffs().data(), 4);
    velocity[i] = take(block);
    spin[i] = take(block);
    mass[i] = block.take();
    inertia[i] = block.take();
  }
  model_->set_state(position, rotation, velocity, spin);
  model_->set_masses(mass, inertia);
  facet_bound_.resize(bounds_are_known ? nodes : 0);
  for (StiffnessBound& bound : facet_bound_) bound = {block.take(), block.take()};
}

}  // namespace encased_column
