#include "files/vtk_spheres_writer.h"

#include "files/vtk_file.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>

namespace encased_column {

bool write_spheres(const std::string& path, const std::vector<std::string>& columns,
                   const std::vector<std::vector<double>>& rows)
{
  const std::array<std::string, 3> coordinates{"x [m]", "y [m]", "z [m]"};
  std::array<std::size_t, 3> place{};
  for (int a = 0; a < 3; ++a)
    place[a] = std::find(columns.begin(), columns.end(), coordinates[a]) - columns.begin();

  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  for (const std::vector<double>& row : rows) {
    const vtkIdType n = points->InsertNextPoint(row[place[0]], row[place[1]], row[place[2]]);
    vertices->InsertNextCell(1, &n);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (std::find(place.begin(), place.end(), c) == place.end())
      add_array<1>(data->GetPointData(), columns[c].c_str(), static_cast<int>(rows.size()),
                   [&](int n) { return rows[n][c]; });
  return write_poly_data(path, data);
}

}  // namespace encased_column
