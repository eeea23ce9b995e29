// The sleeve in restart files: its whole state, so that a run goes on bit by bit.
#include "shell/fix_mesh_surface_shell.h"

#include "host/rank_sums.h"

#include <cstring>
#include <type_traits>

namespace encased_column {

namespace {

constexpr int numbers_per_node = 17;

struct Saved {
  double nodes;
  double pressure_work, support_work, damping_loss, weighed_step, mass_factor;
  PressureRamp pressure;
};

void put(double*& to, const Vec3& v)
{
  for (int a = 0; a < 3; ++a) *to++ = v(a);
}

Vec3 take(const double*& from)
{
  const Vec3 v(from[0], from[1], from[2]);
  from += 3;
  return v;
}

}  // namespace

void FixMeshSurfaceShell::write_restart(FILE* file)
{
  static_assert(std::is_trivially_copyable_v<PressureRamp>);
  const double pressure_work = sum_over_ranks(pressure_work_, world);
  if (comm->me != 0) return;
  const int nodes = model_->nodes();
  const Saved saved{static_cast<double>(nodes),
                    pressure_work,
                    support_work_,
                    damping_loss_,
                    weighed_step_,
                    mass_factor_,
                    pressure_};
  std::vector<double> numbers(static_cast<std::size_t>(nodes) * numbers_per_node);
  double* to = numbers.data();
  for (int i = 0; i < nodes; ++i) {
    put(to, model_->position()[i]);
    for (int a = 0; a < 4; ++a) *to++ = model_->rotation()[i].coeffs()(a);
    put(to, model_->velocity()[i]);
    put(to, model_->angular_velocity()[i]);
    *to++ = model_->mass()[i];
    *to++ = model_->inertia()[i];
    *to++ = facet_bound_.empty() ? 0.0 : facet_bound_[i].translation;
    *to++ = facet_bound_.empty() ? 0.0 : facet_bound_[i].rotation;
  }
  const int size = static_cast<int>(sizeof(Saved) + numbers.size() * sizeof(double));
  fwrite(&size, sizeof(int), 1, file);
  fwrite(&saved, sizeof(Saved), 1, file);
  fwrite(numbers.data(), sizeof(double), numbers.size(), file);
}

// The sleeve goes on as it was, but for what the fix line says.
void FixMeshSurfaceShell::restart(char* buffer)
{
  Saved saved{0, 0, 0, 0, 0, 0, PressureRamp(0.0)};
  std::memcpy(static_cast<void*>(&saved), buffer, sizeof(Saved));
  const int nodes = model_->nodes();
  if (saved.nodes != nodes) {
    error->fix_error(
        FLERR, this,
        ("the sleeve of the restart file has " + in_words(saved.nodes) + " nodes, this one " +
         std::to_string(nodes) + ", give the mesh it was made with")
            .c_str());
    return;
  }
  std::vector<double> numbers(static_cast<std::size_t>(nodes) * numbers_per_node);
  std::memcpy(numbers.data(), buffer + sizeof(Saved), numbers.size() * sizeof(double));
  std::vector<Vec3> position(nodes), velocity(nodes), spin(nodes);
  std::vector<Quaternion> rotation(nodes);
  std::vector<double> mass(nodes), inertia(nodes);
  facet_bound_.assign(nodes, {0.0, 0.0});
  const double* from = numbers.data();
  for (int i = 0; i < nodes; ++i) {
    position[i] = take(from);
    for (int a = 0; a < 4; ++a) rotation[i].coeffs()(a) = *from++;
    velocity[i] = take(from);
    spin[i] = take(from);
    mass[i] = *from++;
    inertia[i] = *from++;
    facet_bound_[i] = {from[0], from[1]};
    from += 2;
  }
  model_->set_state(position, rotation, velocity, spin);
  model_->set_masses(mass, inertia);
  pressure_work_ = comm->me == 0 ? saved.pressure_work : 0.0;
  support_work_ = saved.support_work;
  damping_loss_ = saved.damping_loss;
  weighed_step_ = saved.weighed_step;
  mass_factor_ = saved.mass_factor;
  pressure_ = saved.pressure;
  read_pressure(on_fix_line_);
}

}  // namespace encased_column
