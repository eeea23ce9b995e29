// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>

namespace encased_column {

/// A picture for a page that keeps it inside.
struct PictureData {
  std::string base64;  ///< of a PNG file
  int width, height;   ///< [px]
};

/// The picture `file` (PNG), made smaller to be `width` [px] wide at most.
PictureData picture_data(const std::filesystem::path& file, int width);

}  // namespace encased_column
