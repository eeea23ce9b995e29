// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <filesystem>
#include <functional>
#include <string>

class vtkColorTransferFunction;
class vtkDataArray;
class vtkDataSetAttributes;
class vtkPolyData;
class vtkRenderer;

namespace encased_column {

/// Points, facets and arrays of a `.vtp` file of VTK's XML.
vtkSmartPointer<vtkPolyData> read_poly_data(const std::filesystem::path& file);

/// Makes a vertex of each of `points`: mappers draw no bare points.
void add_vertices(vtkPolyData* points);

/// What an array of a file is called, without or with its unit, and its components.
struct ArrayName {
  std::string name, unit;
  int components;
};

/// The array called so; none if there is none.
vtkDataArray* find_array(vtkDataSetAttributes* arrays, const ArrayName& called);

/// The same; throws InputError naming `file` if there is none.
vtkDataArray* array_of(vtkDataSetAttributes* arrays, const ArrayName& called,
                       const std::filesystem::path& file);

/// The grains of `file`: its points and arrays with `sphere_radius` [m].
vtkSmartPointer<vtkPolyData> grain_spheres(const std::filesystem::path& file);

/// Makes `factor` times `values`, of vectors their lengths, what `spheres` are coloured by.
void color_by(vtkPolyData* spheres, vtkDataArray* values, double factor);

/// The spheres, with their arrays, whose number `chosen` takes.
vtkSmartPointer<vtkPolyData> spheres_where(vtkPolyData* spheres,
                                           const std::function<bool(vtkIdType)>& chosen);

/// Adds spheres in the colors `map` has for their scalars, or all of one pale grey without.
void add_spheres(vtkRenderer* renderer, vtkPolyData* spheres, vtkColorTransferFunction* map);

/// Adds spheres that are all of the same very pale grey, without shades: an outline, filled.
void add_flat_spheres(vtkRenderer* renderer, vtkPolyData* spheres);

}  // namespace encased_column
