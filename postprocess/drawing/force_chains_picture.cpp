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
#include <array>
#include <iterator>
#include <vector>

namespace encased_column {

namespace {

constexpr double least_force = 5.0;  // N, as in the study's Figure 13a
constexpr double thickest = 0.015;   // radius of the bar of the largest force, of the width
constexpr double study_levels[] = {20.0, 40.0, 60.0};  // N, of Figure 13b

struct ForceRange {
  double weakest, strongest;  ///< [N]
};

ForceRange force_range(const std::vector<ContactBar>& bars)
{
  const auto [weakest, strongest] = std::minmax_element(
      bars.begin(), bars.end(),
      [](const ContactBar& a, const ContactBar& b) { return a.force < b.force; });
  return {weakest->force, strongest->force};
}

/// Radius [m] of a bar of 1 N in a specimen of `grains`, the strongest of which bears `strongest`.
double radius_of(vtkPolyData* grains, double strongest)
{
  const double* bounds = grains->GetBounds();
  return thickest * (bounds[1] - bounds[0]) / strongest;
}

}  // namespace

bool draw_force_chains(const std::filesystem::path& file, const FrameWithGrains& frame,
                       const std::string& caption)
{
  const std::vector<ContactBar> bars = contact_bars(frame.file, least_force);
  if (bars.empty()) return false;
  const auto [weakest, strongest] = force_range(bars);
  const std::string forces = "contacts of " + fixed(weakest, 1) + " N and more, largest force " +
                             fixed(strongest, 1) + " N";
  const vtkSmartPointer<vtkPolyData> grains = grain_spheres(frame.grains);
  const auto sticks = sticks_of(bars, radius_of(grains, strongest));
  const auto map = colors_for(sticks->GetPointData()->GetScalars());

  vtkNew<vtkRenderer> outline, renderer;
  add_flat_spheres(outline, grains);
  add_sticks(renderer, sticks, map);
  add_color_bar(renderer, map, "contact force [N]");
  add_caption(renderer, caption + '\n' + forces);
  draw_scene(file, renderer, from_front, outline);
  return true;
}

bool draw_force_chains(const std::filesystem::path& file, const NamedFrame& before,
                       const NamedFrame& after, const std::string& caption)
{
  const std::array<const NamedFrame*, 2> frames{&before, &after};
  std::array<std::vector<ContactBar>, 2> bars;
  std::vector<ContactBar> all;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    bars[i] = contact_bars(frames[i]->frame.file, least_force);
    all.insert(all.end(), bars[i].begin(), bars[i].end());
  }
  if (all.empty()) return false;
  const auto [weakest, strongest] = force_range(all);
  const std::string least = fixed(weakest, 1) + " N and more";
  const double radius = radius_of(grain_spheres(before.frame.grains), strongest);
  const auto map = colors_for(sticks_of(all, radius)->GetPointData()->GetScalars());
  std::vector<SceneView> views;
  std::vector<vtkSmartPointer<vtkRenderer>> kept;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto outline = vtkSmartPointer<vtkRenderer>::New();
    const auto renderer = vtkSmartPointer<vtkRenderer>::New();
    add_flat_spheres(outline, grain_spheres(frames[i]->frame.grains));
    if (!bars[i].empty()) add_sticks(renderer, sticks_of(bars[i], radius), map);
    const std::string largest =
        bars[i].empty() ? "none"
                        : "largest force " + fixed(force_range(bars[i]).strongest, 1) + " N";
    views.push_back({renderer, outline, frames[i]->name + ", " + least + ":\n" + largest});
    kept.insert(kept.end(), {outline, renderer});
  }
  draw_scenes(file, views, from_front, caption, map, "contact force [N]");
  return true;
}

bool draw_force_levels(const std::filesystem::path& file, const FrameWithGrains& frame,
                       const std::string& caption, std::optional<double> recorded)
{
  const std::vector<ContactBar> all = contact_bars(frame.file, 0.0);
  if (all.empty()) return false;
  const auto [weakest, strongest] = force_range(all);
  const double complete_from = recorded.value_or(weakest);  // N
  const vtkSmartPointer<vtkPolyData> grains = grain_spheres(frame.grains);
  const double radius = radius_of(grains, strongest);
  const auto map = colors_for(sticks_of(all, radius)->GetPointData()->GetScalars());
  std::vector<SceneView> views;
  std::vector<vtkSmartPointer<vtkRenderer>> kept;
  for (const double level : study_levels) {
    if (level < complete_from) continue;  // the file lacks some of its contacts
    std::vector<ContactBar> bars;
    std::copy_if(all.begin(), all.end(), std::back_inserter(bars),
                 [&](const ContactBar& bar) { return bar.force >= level; });
    const auto outline = vtkSmartPointer<vtkRenderer>::New();
    const auto renderer = vtkSmartPointer<vtkRenderer>::New();
    add_flat_spheres(outline, grains);
    if (!bars.empty()) add_sticks(renderer, sticks_of(bars, radius), map);
    views.push_back({renderer, outline,
                     fixed(level, 0) + " N and more:\n" + std::to_string(bars.size()) +
                         (bars.size() == 1 ? " contact" : " contacts")});
    kept.insert(kept.end(), {outline, renderer});
  }
  if (views.empty()) return false;
  draw_scenes(file, views, from_front, caption, map, "contact force [N]");
  return true;
}

}  // namespace encased_column
