// SPDX-License-Identifier: GPL-2.0-only
#include "output/sleeve_fields.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

namespace {

/// A field of `count` places, at each of them what `value(n)` gives.
template <int components, typename Value>
SurfaceField field(const char* name, int count, const Value& value)
{
  SurfaceField made{name, components, {}};
  for (int n = 0; n < count; ++n) {
    const Eigen::Matrix<double, components, 1> tuple(value(n));
    made.values.insert(made.values.end(), tuple.data(), tuple.data() + components);
  }
  return made;
}

}  // namespace

std::vector<SurfaceField> sleeve_node_fields(const ShellModel& model,
                                             const std::vector<Vec3>& before, const Vec3& axis)
{
  const auto from_axis = [&axis](const Vec3& x) {
    return std::hypot(x.x() - axis.x(), x.y() - axis.y());
  };
  const int nodes = model.nodes();
  return {
      field<3>("displacement [m]", nodes,
               [&](int i) -> Vec3 { return model.position()[i] - before[i]; }),
      field<1>("radial_displacement [m]", nodes,
               [&](int i) { return from_axis(model.position()[i]) - from_axis(before[i]); }),
      field<3>("rotation [rad]", nodes,
               [&](int i) { return rotation_vector(model.rotation()[i]); }),
      field<3>("velocity [m/s]", nodes, [&](int i) -> Vec3 { return model.velocity()[i]; }),
  };
}

std::vector<SurfaceField> sleeve_facet_fields(const ShellModel& model)
{
  std::vector<FacetState> state;
  for (int f = 0; f < model.facets(); ++f) state.push_back(model.facet_state(f));
  std::vector<SurfaceField> fields;
  const auto add = [&](const char* name, PlaneVector FacetState::*quantity, int component) {
    fields.push_back(
        field<1>(name, model.facets(), [&](int f) { return (state[f].*quantity)(component); }));
  };
  add("hoop_strain [-]", &FacetState::strain, 0);
  add("axial_strain [-]", &FacetState::strain, 1);
  add("hoop_tension [N/m]", &FacetState::membrane_force, 0);
  add("axial_force [N/m]", &FacetState::membrane_force, 1);
  add("shear_force [N/m]", &FacetState::membrane_force, 2);
  add("hoop_moment [N m/m]", &FacetState::moment, 0);
  add("axial_moment [N m/m]", &FacetState::moment, 1);
  fields.push_back(field<1>("energy [J]", model.facets(), [&](int f) {
    return state[f].membrane_energy + state[f].bending_energy;
  }));
  for (int i = 0; i < 2; ++i)
    fields.push_back(field<1>(i == 0 ? "plastic_hoop_strain [-]" : "plastic_axial_strain [-]",
                              model.facets(),
                              [&](int f) { return model.memory(f).plastic_strain[i]; }));
  fields.push_back(field<1>("damage [-]", model.facets(), [&](int f) {
    const FacetMemory memory = model.memory(f);
    return std::max(memory.damage[0], memory.damage[1]);
  }));
  return fields;
}

}  // namespace encased_column
