// SPDX-License-Identifier: GPL-2.0-only
#include "shell/sleeve.h"

#include "shell/enclosed_volume.h"
#include "shell/level_cut.h"
#include "shell/seam.h"
#include "shell/sleeve_record.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace encased_column {

namespace {

constexpr int checks_apart = 4;  ///< times `every`, between two checks of the facets

/// A sleeve's mesh with outward facets, whatever way a file turns them.
SurfaceMesh facing_outward(SurfaceMesh mesh)
{
  require_sleeve(mesh);
  const int facets = static_cast<int>(mesh.facet.size());
  if (!(enclosed_volume(mesh.facet, mesh.node, 0, facets, HeightWindow()) > 0.0))
    for (Facet& facet : mesh.facet) std::swap(facet[1], facet[2]);
  return mesh;
}

double mean_height(const std::vector<int>& nodes, const std::vector<Vec3>& position)
{
  double sum = 0.0;
  for (const int node : nodes) sum += position[node].z();
  return sum / static_cast<double>(nodes.size());
}

}  // namespace

Sleeve::Sleeve(const SurfaceMesh& mesh, const ShellConstants& constants, const NodalMassRule& rule,
               Rank rank)
    : rank_(rank),
      model_(facing_outward(mesh), constants, Vec3::UnitZ()),
      masses_(rule)
{
  const SurfaceMesh outward{model_.reference(), model_.facet()};
  const auto loops = border_loops(outward);
  const bool first_is_top =
      mean_height(loops[0], outward.node) > mean_height(loops[1], outward.node);
  end_nodes_[0] = loops[first_is_top ? 0 : 1];
  end_nodes_[1] = loops[first_is_top ? 1 : 0];
  require_upright();
  for (const Vec3& node : outward.node) axis_ += node / static_cast<double>(outward.node.size());
  axis_.z() = 0.0;
  pairs_ = facet_pairs(outward);
  if (const ClothConstants& cloth = constants.cloth; cloth.seam < 1.0)
    model_.cloth().weaken(facets_on_line(outward.facet, outward.node, axis_, cloth.seam_angle),
                          cloth.seam);
  const long facets = model_.facets();
  first_ = static_cast<int>(facets * rank_.number / rank_.count);
  last_ = static_cast<int>(facets * (rank_.number + 1) / rank_.count);
  touched_ = TouchedNodes(model_.nodes(), rank_.count);
  place_supports();
}

// Volumes, sections and the pressure's window go by the height.
void Sleeve::require_upright() const
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const int node : end_nodes_[0]) low = std::min(low, model_.reference()[node].z());
  for (const int node : end_nodes_[1]) high = std::max(high, model_.reference()[node].z());
  if (low > high) return;
  throw InputError(
      "the axis of a sleeve must stand along z, one end above the other, found the lower end up "
      "to " +
      in_words(high) + " m and the upper one down to " + in_words(low) + " m: turn the mesh");
}

void Sleeve::set_control(const SleeveControl& control, long step)
{
  // One that comes from a restart file with the masses of a step was released before.
  if (control_.rigid && !control.rigid && !masses_.are_of_a_step()) released_ = step;
  control_ = control;
  place_supports();
}

void Sleeve::place_supports()
{
  std::vector<Support>& supports = model_.support();
  supports.clear();
  add_supports(control_.ends[0], end_nodes_[0], Vec3::UnitZ(), supports);
  first_bottom_support_ = supports.size();
  add_supports(control_.ends[1], end_nodes_[1], Vec3::UnitZ(), supports);
}

void Sleeve::advance(double dt, const std::array<double, 2>& platen_speeds)
{
  if (control_.rigid) return;
  std::vector<Support>& supports = model_.support();
  for (std::size_t n = 0; n < supports.size(); ++n) {
    const int end = n < first_bottom_support_ ? 0 : 1;
    if (control_.ends[end] != SleeveEnd::platen) continue;
    const double inward = platen_speeds[end];
    supports[n].velocity = Vec3(0.0, 0.0, end == 0 ? -inward : inward);
  }
  const StepWork work = model_.advance(dt, control_.damping);
  pressure_work_ += work.external;
  support_work_ += work.supports;
  damping_loss_ += work.damping;
}

void Sleeve::start_loads(const SleeveStep& step, const HeightWindow& window, bool at_set_up)
{
  vertical_force_ = 0.0;
  masses_.start(step, at_set_up, control_.rigid, model_.nodes());
  std::vector<Vec3>& external = model_.external();
  std::fill(external.begin(), external.end(), Vec3::Zero());
  if (const double pressure = pressure_.at(step.number); pressure != 0.0 && !control_.rigid)
    add_pressure(model_.facet(), model_.position(), first_, last_, -pressure,
                 control_.pressed_everywhere ? HeightWindow() : window, external);
  model_.load_external();
  if (!control_.rigid) energy_ = model_.add_internal_loads(first_, last_, at_set_up);
}

void Sleeve::find_reactions()
{
  if (!control_.rigid) model_.find_reactions();
}

bool Sleeve::is_time_to_check(long step) const
{
  return step % (checks_apart * masses_.rule().every) == 0;
}

std::optional<std::string> Sleeve::fault(long step) const
{
  std::optional<std::string> fault;
  if (control_.stops_when_torn) fault = torn_facet(model_, first_, last_, axis_);
  if (!fault)
    fault =
        fault_of_facets(model_, first_, last_, control_.strain_limit, steps_since_release(step));
  if (!fault && rank_.number == 0) fault = fault_of_pairs(model_, pairs_);
  return fault;
}

std::string Sleeve::sentence_of(const GrainBehind& behind, long tag, const std::string& id,
                                long step) const
{
  return "grain " + std::to_string(tag) + " is on the wrong side of facet " +
         std::to_string(behind.facet) + " of sleeve '" + id + "' at step " + std::to_string(step) +
         ", " +
         advice_for(steps_since_release(step),
                    "load more slowly or raise the contact modulus of the sleeve");
}

std::vector<std::string> Sleeve::warnings(const HeightWindow& window, const std::string& id,
                                          const std::array<std::string, 2>& platens, long step)
{
  std::vector<std::string> sentences;
  watch_.look_at_ends(model_, end_nodes_, window, id, platens, step, sentences);
  watch_.look_at_strength(model_, id, step, sentences);
  return sentences;
}

double Sleeve::enclosed_volume(const HeightWindow& window) const
{
  return encased_column::enclosed_volume(model_.facet(), model_.position(), 0, model_.facets(),
                                         window);
}

double Sleeve::level_inside(double z) const
{
  // Where both ends are whole as they are now; not on their nodes, where a platen stands at the
  // start.
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  for (const int node : end_nodes_[0]) high = std::min(high, model_.position()[node].z());
  for (const int node : end_nodes_[1]) low = std::max(low, model_.position()[node].z());
  const double reserve = 1e-6 * (high - low);
  return low < high ? std::clamp(z, low + reserve, high - reserve) : z;
}

double Sleeve::cross_section(double z) const
{
  return area_at_level(model_.facet(), model_.position(), level_inside(z));
}

int Sleeve::count_outside(const double* centers, int count, const HeightWindow& window) const
{
  const InsideTest sleeve(model_.facet(), model_.position());
  int outside = 0;
  for (const double* x = centers; x != centers + 3 * count; x += 3)
    outside += x[2] < window.low || x[2] > window.high || !sleeve.is_inside(as_vec3(x));
  return outside;
}

double Sleeve::axial_force(bool top) const
{
  const std::vector<Support>& supports = model_.support();
  double sum = 0.0;
  for (std::size_t n = 0; n < supports.size(); ++n)
    if ((n < first_bottom_support_) == top) sum += supports[n].force.z();
  return sum;
}

std::vector<double> Sleeve::state(double pressure_work, double dissipated) const
{
  std::vector<double> numbers{static_cast<double>(model_.nodes()), pressure_work, support_work_,
                              damping_loss_};
  masses_.save(numbers);
  for (const double number : pressure_.state()) numbers.push_back(number);
  save_nodes(model_, numbers);
  masses_.save_bounds(numbers);
  save_memory(model_, dissipated, numbers);
  return numbers;
}

void Sleeve::restore(const std::vector<double>& state)
{
  NumberRow numbers(state);
  if (const double saved = numbers.take(); saved != model_.nodes())
    throw InputError("the sleeve of the restart file has " + in_words(saved) + " nodes, this one " +
                     std::to_string(model_.nodes()) + ", give the mesh it was made with");
  const double pressure_work = numbers.take();
  pressure_work_ = rank_.number == 0 ? pressure_work : 0.0;
  support_work_ = numbers.take();
  damping_loss_ = numbers.take();
  masses_.restore(numbers);
  std::array<double, PressureRamp::numbers> ramp;
  numbers.take(ramp.data(), PressureRamp::numbers);
  pressure_.restore(ramp);
  restore_nodes(model_, numbers);
  masses_.restore_bounds(numbers, model_.nodes());
  restore_memory(model_, numbers);
  if (rank_.number != 0) model_.cloth().set_dissipated(0.0);
}

}  // namespace encased_column
