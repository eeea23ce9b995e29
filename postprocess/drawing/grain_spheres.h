#pragma once

#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

class vtkColorTransferFunction;
class vtkDataArray;
class vtkDataSetAttributes;
class vtkPolyData;
class vtkRenderer;

namespace encased_column {

/// Points, facets and arrays of a `.vtp` file of VTK's XML.
vtkSmartPointer<vtkPolyData> read_poly_data(const std::filesystem::path& file);

/// The array `name` (with its unit, or without) of `components`; throws InputError if there is
/// none.
vtkDataArray* array_of(vtkDataSetAttributes* arrays, const std::string& name,
                       const std::string& unit, int components, const std::filesystem::path& file);

/// The grains of `file`: points with `sphere_radius` [m] and, as scalars, the distance moved [mm].
vtkSmartPointer<vtkPolyData> grain_spheres(const std::filesystem::path& file);

/// Adds them as spheres, in the colors of `map`, or all of one pale grey without.
void add_spheres(vtkRenderer* renderer, vtkPolyData* spheres, vtkColorTransferFunction* map);

}  // namespace encased_column
