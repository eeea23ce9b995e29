#include "reading/sleeve_surface.h"

#include "core/input_error.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>
#include <vtkXMLPolyDataReader.h>

namespace encased_column {

long count_beyond_sleeve(const std::vector<std::array<double, 3>>& centers,
                         const std::filesystem::path& file)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0 || reader->GetOutput()->GetNumberOfPolys() == 0)
    throw InputError("'" + file.string() + "' must hold the facets of a sleeve, found none, " +
                     "run the case again or remove its folder sleeve");
  vtkNew<vtkStaticCellLocator> facets;
  facets->SetDataSet(reader->GetOutput());
  facets->BuildLocator();
  long beyond = 0;
  for (const std::array<double, 3>& center : centers) {
    const double axis[3] = {0.0, 0.0, center[2]};
    double way = 0.0, where[3], in_facet[3];
    int part = 0;
    beyond += facets->IntersectWithLine(axis, center.data(), 0.0, way, where, in_facet, part) != 0;
  }
  return beyond;
}

}  // namespace encased_column
