// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

namespace encased_column::testing {

/// A 3-D picture; what is told of rows is told left of its color bar.
class PicturePixels {
 public:
  explicit PicturePixels(const std::filesystem::path& file)
  {
    reader_->SetFileName(file.c_str());
    reader_->Update();
  }
  bool has_the_size_of_all() const
  {
    const int* size = reader_->GetOutput()->GetDimensions();
    return size[0] == 1200 && size[1] == 1500;
  }
  int width() const { return reader_->GetOutput()->GetDimensions()[0]; }
  int height() const { return reader_->GetOutput()->GetDimensions()[1]; }
  /// From the left and the lower edge.
  std::array<int, 3> pixel(int x, int y) const
  {
    const auto* rgb = static_cast<unsigned char*>(reader_->GetOutput()->GetScalarPointer(x, y, 0));
    return {rgb[0], rgb[1], rgb[2]};
  }
  bool is_white(int x, int y) const { return pixel(x, y) == std::array<int, 3>{255, 255, 255}; }
  bool is_colored(int x, int y) const
  {
    const auto rgb = pixel(x, y);
    return *std::max_element(rgb.begin(), rgb.end()) - *std::min_element(rgb.begin(), rgb.end()) >
           40;
  }
  /// Widths [px] of what is colored along the row `y`, from the left.
  std::vector<int> colored_widths(int y) const { return colored_widths(y, 1, right); }
  std::vector<int> colored_widths(int y, int from, int to) const
  {
    std::vector<int> widths;
    for (int x = from; x < to; ++x) {
      if (!is_colored(x, y)) continue;
      if (!is_colored(x - 1, y)) widths.push_back(0);
      ++widths.back();
    }
    return widths;
  }
  /// Whether most of what is colored between two rows is as yellow as the end of the colors, or as
  /// violet as their begin.
  bool is_yellow(int from, int to) const
  {
    return share(from, to, [](const auto& rgb) { return rgb[0] > rgb[2] && rgb[1] > rgb[2]; }) >
           0.9;
  }
  bool is_violet(int from, int to) const
  {
    return share(from, to, [](const auto& rgb) { return rgb[2] > rgb[1] && rgb[0] > rgb[1]; }) >
           0.9;
  }
  static constexpr int right = 900, top = 1400;

 private:
  template <typename Test>
  double share(int from, int to, Test test) const
  {
    double all = 0.0, found = 0.0;
    for (int y = from; y < to; ++y)
      for (int x = 0; x < right; ++x)
        if (is_colored(x, y)) {
          all += 1.0;
          found += test(pixel(x, y));
        }
    return found / all;
  }
  vtkNew<vtkPNGReader> reader_;
};

}  // namespace encased_column::testing
