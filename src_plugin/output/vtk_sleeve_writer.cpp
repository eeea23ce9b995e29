#include "output/vtk_sleeve_writer.h"

#include "files/vtk_file.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace encased_column {

namespace {

void add_surface(vtkPolyData* data, const ShellModel& model)
{
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(model.nodes());
  for (int i = 0; i < model.nodes(); ++i) points->SetPoint(i, model.position()[i].data());
  vtkNew<vtkCellArray> facets;
  for (const Facet& f : model.facet()) {
    const vtkIdType corners[3] = {f[0], f[1], f[2]};
    facets->InsertNextCell(3, corners);
  }
  data->SetPoints(points);
  data->SetPolys(facets);
}

void add_node_fields(vtkPolyData* data, const ShellModel& model, const std::vector<Vec3>& before,
                     const Vec3& axis)
{
  const auto from_axis = [&axis](const Vec3& x) {
    return std::hypot(x.x() - axis.x(), x.y() - axis.y());
  };
  const int nodes = model.nodes();
  vtkPointData* to = data->GetPointData();
  add_array<3>(to, "displacement [m]", nodes,
               [&](int i) -> Vec3 { return model.position()[i] - before[i]; });
  add_array<1>(to, "radial_displacement [m]", nodes,
               [&](int i) { return from_axis(model.position()[i]) - from_axis(before[i]); });
  add_array<3>(to, "rotation [rad]", nodes,
               [&](int i) { return rotation_vector(model.rotation()[i]); });
  add_array<3>(to, "velocity [m/s]", nodes, [&](int i) -> Vec3 { return model.velocity()[i]; });
}

void add_facet_fields(vtkPolyData* data, const ShellModel& model)
{
  std::vector<FacetState> state;
  for (int f = 0; f < model.facets(); ++f) state.push_back(model.facet_state(f));
  const int facets = model.facets();
  vtkCellData* to = data->GetCellData();
  const auto add = [&](const char* name, PlaneVector FacetState::*field, int component) {
    add_array<1>(to, name, facets, [&](int f) { return (state[f].*field)(component); });
  };
  add("hoop_strain [-]", &FacetState::strain, 0);
  add("axial_strain [-]", &FacetState::strain, 1);
  add("hoop_tension [N/m]", &FacetState::membrane_force, 0);
  add("axial_force [N/m]", &FacetState::membrane_force, 1);
  add("shear_force [N/m]", &FacetState::membrane_force, 2);
  add("hoop_moment [N m/m]", &FacetState::moment, 0);
  add("axial_moment [N m/m]", &FacetState::moment, 1);
  add_array<1>(to, "energy [J]", facets,
               [&](int f) { return state[f].membrane_energy + state[f].bending_energy; });
  add_array<1>(to, "plastic_hoop_strain [-]", facets,
               [&](int f) { return model.memory(f).plastic_strain[0]; });
  add_array<1>(to, "plastic_axial_strain [-]", facets,
               [&](int f) { return model.memory(f).plastic_strain[1]; });
  add_array<1>(to, "damage [-]", facets, [&](int f) {
    const FacetMemory memory = model.memory(f);
    return std::max(memory.damage[0], memory.damage[1]);
  });
}

}  // namespace

bool write_sleeve(const std::string& path, const ShellModel& model, const std::vector<Vec3>& before,
                  const Vec3& axis)
{
  vtkNew<vtkPolyData> data;
  add_surface(data, model);
  add_node_fields(data, model, before, axis);
  add_facet_fields(data, model);
  return write_poly_data(path, data);
}

}  // namespace encased_column
