// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/pictures.h"

#include "drawing/grain_spheres.h"
#include "drawing/scene.h"

#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

namespace encased_column {

bool draw_shear_band(const std::filesystem::path& file, const std::filesystem::path& grains,
                     const std::string& caption)
{
  const vtkSmartPointer<vtkPolyData> all = grain_spheres(grains);
  vtkDataArray* strain = find_array(all->GetPointData(), {"deviatoric_strain", "-", 1});
  if (!strain) return false;
  color_by(all, strain, 100.0);
  const double axis = all->GetCenter()[1];
  const auto behind = [&](vtkIdType i) { return all->GetPoint(i)[1] >= axis; };
  const auto known = [&](vtkIdType i) { return strain->GetTuple1(i) >= 0.0; };
  const auto colored = spheres_where(all, [&](vtkIdType i) { return behind(i) && known(i); });
  const auto grey = spheres_where(all, [&](vtkIdType i) { return behind(i) && !known(i); });
  if (colored->GetNumberOfPoints() == 0) return false;

  const auto map = colors_for(colored->GetPointData()->GetScalars());
  vtkNew<vtkRenderer> renderer;
  add_spheres(renderer, colored, map);
  add_spheres(renderer, grey, nullptr);
  add_color_bar(renderer, map, "deviatoric strain [%]");
  add_caption(renderer, caption);
  draw_scene(file, renderer, from_front);
  return true;
}

}  // namespace encased_column
