// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/pictures.h"

#include "drawing/grain_spheres.h"
#include "drawing/scene.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

namespace encased_column {

void draw_specimen(const std::filesystem::path& file, const std::filesystem::path& grains,
                   const std::string& caption)
{
  const vtkSmartPointer<vtkPolyData> spheres = grain_spheres(grains);
  color_by(spheres, array_of(spheres->GetPointData(), {"displacement", "m", 3}, grains), 1e3);
  const auto map = colors_for(spheres->GetPointData()->GetScalars());
  vtkNew<vtkRenderer> renderer;
  add_spheres(renderer, spheres, map);
  add_color_bar(renderer, map, "displacement [mm]");
  add_caption(renderer, caption);
  draw_scene(file, renderer, from_front);
}

}  // namespace encased_column
