// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>
#include <vector>

class vtkColorTransferFunction;
class vtkDataArray;
class vtkRenderer;

namespace encased_column {

/// Viridis from `low` to `high` > low.
vtkSmartPointer<vtkColorTransferFunction> viridis(double low, double high);

/// Colors for `values`, from zero to the value 1 in 200 exceeds: a few must not hide what all
/// others do. Where 1 in 200 falls below zero by more than 5 % of that, from there on. Both ends
/// are rounded away from zero.
vtkSmartPointer<vtkColorTransferFunction> colors_for(vtkDataArray* values);

/// Draws from now on without smoothing: ragged edges, in a third of the time.
void draw_drafts();

/// A bar with the colors of `map` at the right edge, titled with quantity and unit.
void add_color_bar(vtkRenderer* renderer, vtkColorTransferFunction* map, const std::string& title);

/// One line or two at the upper edge.
void add_caption(vtkRenderer* renderer, const std::string& caption);

/// The direction [deg] of -y, straight onto the plane through the axis that pictures cut along.
constexpr double from_front = -90.0;

/// Draws what `renderer` holds into `file`.png, 1200 x 1500 px, seen from the direction `azimuth`
/// [deg] around z (0: from +x, 90: from +y) and a little from above; z points up, the bodies stand
/// left of the middle, where the bar leaves room. What `backdrop` holds, and it alone decides what
/// the picture must hold then, lies behind all of it.
void draw_scene(const std::filesystem::path& file, vtkRenderer* renderer, double azimuth,
                vtkRenderer* backdrop = nullptr);

/// One of several pictures side by side.
struct SceneView {
  vtkRenderer* renderer;
  vtkRenderer* backdrop;  ///< all that it must hold lies in it
  std::string label;      ///< above it, lines of its own
};

/// Draws `views` side by side into `file`.png, 1500 px wide and as high as the bodies need, at one
/// scale and seen as draw_scene() does, with `caption` above them and a bar of the colors of `map`,
/// titled `title`, right of them.
void draw_scenes(const std::filesystem::path& file, const std::vector<SceneView>& views,
                 double azimuth, const std::string& caption, vtkColorTransferFunction* map,
                 const std::string& title);

}  // namespace encased_column
