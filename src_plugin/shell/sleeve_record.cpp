// SPDX-License-Identifier: GPL-2.0-only
#include "shell/sleeve_record.h"

namespace encased_column {

namespace {

constexpr int numbers_of_memory = 6;  ///< numbers of a FacetMemory

void put(const Vec3& v, std::vector<double>& to)
{
  to.insert(to.end(), v.data(), v.data() + 3);
}

}  // namespace

void save_nodes(const ShellModel& model, std::vector<double>& numbers)
{
  for (int i = 0; i < model.nodes(); ++i) {
    put(model.position()[i], numbers);
    for (int a = 0; a < 4; ++a) numbers.push_back(model.rotation()[i].coeffs()(a));
    put(model.velocity()[i], numbers);
    put(model.angular_velocity()[i], numbers);
    numbers.push_back(model.mass()[i]);
    numbers.push_back(model.inertia()[i]);
  }
}

void restore_nodes(ShellModel& model, NumberRow& numbers)
{
  const int nodes = model.nodes();
  std::vector<Vec3> position(nodes), velocity(nodes), spin(nodes);
  std::vector<Quaternion> rotation(nodes);
  std::vector<double> mass(nodes), inertia(nodes);
  for (int i = 0; i < nodes; ++i) {
    numbers.take(position[i].data(), 3);
    numbers.take(rotation[i].coeffs().data(), 4);
    numbers.take(velocity[i].data(), 3);
    numbers.take(spin[i].data(), 3);
    mass[i] = numbers.take();
    inertia[i] = numbers.take();
  }
  model.set_state(position, rotation, velocity, spin);
  model.set_masses(mass, inertia);
}

std::vector<double> memory_numbers(const ShellModel& model, int first, int last)
{
  std::vector<double> numbers(numbers_of_memory * model.facets(), 0.0);
  for (int f = first; f < last; ++f) {
    const FacetMemory memory = model.cloth().memory(f);
    double* to = numbers.data() + numbers_of_memory * f;
    to = std::copy(memory.plastic_strain.begin(), memory.plastic_strain.end(), to);
    to = std::copy(memory.damage.begin(), memory.damage.end(), to);
    to[0] = memory.slip;
    to[1] = memory.most_shear;
  }
  return numbers;
}

void take_memory(ShellModel& model, const std::vector<double>& numbers)
{
  const double* from = numbers.data();
  for (int f = 0; f < model.facets(); ++f, from += numbers_of_memory)
    model.cloth().set_memory(f, {{from[0], from[1]}, {from[2], from[3]}, from[4], from[5]});
}

void save_memory(const ShellModel& model, double dissipated, std::vector<double>& numbers)
{
  const bool remembers = model.cloth().remembers();
  numbers.push_back(remembers ? model.facets() : 0.0);
  if (!remembers) return;
  numbers.push_back(dissipated);
  const std::vector<double> memory = memory_numbers(model, 0, model.facets());
  numbers.insert(numbers.end(), memory.begin(), memory.end());
}

void restore_memory(ShellModel& model, NumberRow& numbers)
{
  const double facets = numbers.take();
  const double wanted = model.cloth().remembers() ? model.facets() : 0.0;
  if (facets != wanted)
    throw InputError("the sleeve of the restart file remembers plastic strain and damage of " +
                     in_words(facets) + " facets, this one of " + in_words(wanted) +
                     ", give the same 'strip', 'strength' and 'after_strength'");
  if (facets == 0.0) return;
  model.cloth().set_dissipated(numbers.take());
  std::vector<double> memory(numbers_of_memory * model.facets());
  numbers.take(memory.data(), memory.size());
  take_memory(model, memory);
}

}  // namespace encased_column
