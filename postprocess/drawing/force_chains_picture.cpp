// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/pictures.h"

#include "drawing/contact_bars.h"
#include "drawing/grain_spheres.h"
#include "drawing/scene.h"
#include "tables/text_layout.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace encased_column {

namespace {

constexpr double least_force = 5.0;  // N, as in the study's Figure 13
constexpr double thickest = 0.015;   // radius of the bar of the largest force, of the width

}  // namespace

bool draw_force_chains(const std::filesystem::path& file, const FrameWithGrains& frame,
                       const std::string& caption)
{
  const std::vector<ContactBar> bars = contact_bars(frame.file, least_force);
  if (bars.empty()) return false;
  const auto [weakest, strongest] = std::minmax_element(
      bars.begin(), bars.end(),
      [](const ContactBar& a, const ContactBar& b) { return a.force < b.force; });
  const std::string forces = "contacts of " + fixed(weakest->force, 1) +
                             " N and more, largest force " + fixed(strongest->force, 1) + " N";
  const vtkSmartPointer<vtkPolyData> grains = grain_spheres(frame.grains);
  const double* bounds = grains->GetBounds();
  const auto sticks = sticks_of(bars, thickest * (bounds[1] - bounds[0]) / strongest->force);
  const auto map = colors_for(sticks->GetPointData()->GetScalars());

  vtkNew<vtkRenderer> outline, renderer;
  add_flat_spheres(outline, grains);
  add_sticks(renderer, sticks, map);
  add_color_bar(renderer, map, "contact force [N]");
  add_caption(renderer, caption + '\n' + forces);
  draw_scene(file, renderer, from_front, outline);
  return true;
}

}  // namespace encased_column
