#pragma once

#include <vtkDataSetAttributes.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>

#include <string>

#include <Eigen/Core>

class vtkPolyData;

namespace encased_column {

/// An array of `count` tuples in single precision, each what `value(n)` gives.
template <int components, typename Value>
void add_array(vtkDataSetAttributes* to, const char* name, int count, const Value& value)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  for (int n = 0; n < count; ++n) {
    const Eigen::Matrix<double, components, 1> tuple(value(n));
    array->SetTuple(n, tuple.data());
  }
  to->AddArray(array);
}

/// Writes a VTK XML file (.vtp), its arrays in raw binary; false when it cannot be written. A
/// reader never sees a part of it.
bool write_poly_data(const std::string& path, vtkPolyData* data, bool compress = true);

}  // namespace encased_column
