#include "shell/sleeve.h"

#include "shell/enclosed_volume.h"
#include "shell/level_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace encased_column {

namespace {

constexpr int checks_apart = 4;   ///< times `every`, between two checks of the facets
constexpr int bounds_apart = 20;  ///< times `every`, between two bounds of the facets' stiffness
/// Distance [m] between platen and end of the sleeve that no grain of a test passes through.
constexpr double end_tolerance = 1e-4;

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

void put(const Vec3& v, std::vector<double>& to)
{
  to.insert(to.end(), v.data(), v.data() + 3);
}

}  // namespace

Sleeve::Sleeve(const SurfaceMesh& mesh, const ShellConstants& constants, const NodalMassRule& rule,
               Rank rank)
    : rule_(rule),
      rank_(rank),
      model_(facing_outward(mesh), constants, Vec3::UnitZ())
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
  const long facets = model_.facets();
  first_ = static_cast<int>(facets * rank_.number / rank_.count);
  last_ = static_cast<int>(facets * (rank_.number + 1) / rank_.count);
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
  if (control_.rigid && !control.rigid && mass_step_ == 0.0) released_ = step;
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

// A set-up leaves masses that were made for this length of step as they are.
void Sleeve::start_loads(const SleeveStep& step, const HeightWindow& window, bool at_set_up)
{
  model_.clear_loads();
  vertical_force_ = 0.0;
  updates_masses_ = mass_step_ != step.length || (!at_set_up && step.number % rule_.every == 0);
  if (control_.rigid) {
    updates_masses_ = false;
    mass_step_ = 0.0;  // a release starts from the true masses
    return;
  }
  energy_ = model_.add_internal_loads(first_, last_);
  if (const double pressure = pressure_.at(step.number); pressure != 0.0) {
    add_pressure(model_.facet(), model_.position(), first_, last_, -pressure,
                 control_.pressed_everywhere ? HeightWindow() : window, model_.external());
    for (int i = 0; i < model_.nodes(); ++i) model_.force(i) += model_.external()[i];
  }
  if (updates_masses_) contact_bound_.assign(model_.nodes(), {0.0, 0.0});
}

const std::vector<int>& Sleeve::list_grains(const double* centers, const double* radii, int grains,
                                            double margin)
{
  contacts_.list(model_, centers, radii, grains, margin);
  return contacts_.grains();
}

/// True where the bound is that of this rank's facets and must be summed.
bool Sleeve::find_facet_bound(const SleeveStep& step)
{
  if (!facet_bound_.empty() && step.number % (bounds_apart * rule_.every) != 0) return false;
  facet_bound_.assign(model_.nodes(), {0.0, 0.0});
  model_.add_stiffness(first_, last_, facet_bound_);
  return true;
}

void Sleeve::update_nodal_masses(const SleeveStep& step)
{
  for (int i = 0; i < model_.nodes(); ++i) {
    contact_bound_[i].translation += facet_bound_[i].translation;
    contact_bound_[i].rotation += facet_bound_[i].rotation;
  }
  const bool from_true_masses = mass_step_ != step.length;
  mass_step_ = step.length;
  if (rule_.scaled) {
    damping_loss_ +=
        model_.scale_masses(contact_bound_, step.length, rule_.safety, from_true_masses);
    mass_factor_ = model_.mass_factor();
    return;
  }
  const double stable = model_.stable_step(contact_bound_, rule_.safety);
  if (step.length > stable)
    throw InputError("the step of " + in_words(step.length) +
                     " s is longer than the sleeve's stable " + in_words(stable) +
                     " s, write a shorter step or 'mass_scaling yes'");
}

void Sleeve::find_reactions()
{
  if (!control_.rigid) model_.find_reactions();
}

bool Sleeve::is_time_to_check(long step) const
{
  return step % (checks_apart * rule_.every) == 0;
}

std::optional<std::string> Sleeve::fault(long step) const
{
  auto fault =
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
  const double heights[2] = {window.high, window.low};
  for (int n = 0; n < 2; ++n) {
    const double upwards = n == 0 ? 1.0 : -1.0;
    double beyond = std::numeric_limits<double>::infinity();
    for (const int node : end_nodes_[n])
      beyond = std::min(beyond, upwards * (heights[n] - model_.position()[node].z()));
    if (platen_told_[n] || !std::isfinite(heights[n]) || beyond <= end_tolerance) continue;
    platen_told_[n] = true;
    sentences.push_back("platen '" + platens[n] + "' stands " + in_words(beyond) +
                        " m beyond the end of sleeve '" + id + "' at step " + std::to_string(step) +
                        ", grains can escape there: hold the platen or make the sleeve longer");
  }
  if (control_.rupture <= 0.0 || rupture_told_) return sentences;
  const double tension = summary_of(model_, window).hoop_tension_max;
  if (tension <= control_.rupture) return sentences;
  rupture_told_ = true;
  sentences.push_back("the hoop tension of sleeve '" + id + "' is " + in_words(tension) +
                      " N/m at step " + std::to_string(step) + " and passes its 'rupture' of " +
                      in_words(control_.rupture) + " N/m; it does not tear");
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

std::vector<double> Sleeve::state(double pressure_work) const
{
  const int nodes = model_.nodes();
  std::vector<double> numbers{static_cast<double>(nodes),
                              pressure_work,
                              support_work_,
                              damping_loss_,
                              mass_step_,
                              mass_factor_,
                              facet_bound_.empty() ? 0.0 : 1.0};
  for (const double number : pressure_.state()) numbers.push_back(number);
  for (int i = 0; i < nodes; ++i) {
    put(model_.position()[i], numbers);
    for (int a = 0; a < 4; ++a) numbers.push_back(model_.rotation()[i].coeffs()(a));
    put(model_.velocity()[i], numbers);
    put(model_.angular_velocity()[i], numbers);
    numbers.push_back(model_.mass()[i]);
    numbers.push_back(model_.inertia()[i]);
  }
  for (const StiffnessBound& bound : facet_bound_) {
    numbers.push_back(bound.translation);
    numbers.push_back(bound.rotation);
  }
  return numbers;
}

void Sleeve::restore(const std::vector<double>& state)
{
  const double* from = state.data();
  const auto take = [&](double* numbers, int count) {
    if (from + count > state.data() + state.size())
      throw InputError("the sleeve of the restart file must be whole, found " +
                       std::to_string(state.size()) + " numbers, go on from another file");
    std::copy_n(from, count, numbers);
    from += count;
  };
  const auto take_one = [&] {
    double number;
    take(&number, 1);
    return number;
  };
  const int nodes = model_.nodes();
  if (const double saved = take_one(); saved != nodes)
    throw InputError("the sleeve of the restart file has " + in_words(saved) + " nodes, this one " +
                     std::to_string(nodes) + ", give the mesh it was made with");
  const double pressure_work = take_one();
  pressure_work_ = rank_.number == 0 ? pressure_work : 0.0;
  support_work_ = take_one();
  damping_loss_ = take_one();
  mass_step_ = take_one();
  mass_factor_ = take_one();
  // A sleeve that was never released has none yet: its release must find them, not take zeros.
  const bool bounds_are_known = take_one() != 0.0;
  std::array<double, PressureRamp::numbers> ramp;
  take(ramp.data(), PressureRamp::numbers);
  pressure_.restore(ramp);
  std::vector<Vec3> position(nodes), velocity(nodes), spin(nodes);
  std::vector<Quaternion> rotation(nodes);
  std::vector<double> mass(nodes), inertia(nodes);
  for (int i = 0; i < nodes; ++i) {
    take(position[i].data(), 3);
    take(rotation[i].coeffs().data(), 4);
    take(velocity[i].data(), 3);
    take(spin[i].data(), 3);
    mass[i] = take_one();
    inertia[i] = take_one();
  }
  model_.set_state(position, rotation, velocity, spin);
  model_.set_masses(mass, inertia);
  facet_bound_.resize(bounds_are_known ? nodes : 0);
  for (StiffnessBound& bound : facet_bound_) {
    bound.translation = take_one();
    bound.rotation = take_one();
  }
}

}  // namespace encased_column
