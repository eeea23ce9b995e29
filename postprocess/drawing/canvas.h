// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>

class vtkRenderWindow;
class vtkTextProperty;

namespace encased_column {

/// Sets the size [px] and makes `window` draw without appearing on the display, with so many
/// samples a pixel against jagged edges.
void prepare_window(vtkRenderWindow* window, int width, int height, int samples = 8);

/// DejaVu Sans of `size` [px] in near black, for its Greek letters; VTK's own font where that is
/// not installed (package fonts-dejavu-core).
void set_font(vtkTextProperty* text, int size);

/// Draws `window` into `file`.png or `file`.svg; the latter keeps text as text and is for charts.
/// `finer` draws that many pixels for each one written, in both directions, against jagged edges.
/// Throws InputError if the file cannot be written.
void write_png(const std::filesystem::path& file, vtkRenderWindow* window, int finer = 1);
void write_svg(const std::filesystem::path& file, vtkRenderWindow* window);

/// What write_svg() would write, without the element svg around it and what says no more than the
/// defaults of SVG.
std::string svg_elements(vtkRenderWindow* window);

}  // namespace encased_column
