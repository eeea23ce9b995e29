// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>

namespace encased_column {

/// A new folder for temporary files that goes, with all in it, with this object. `purpose` says
/// what for, as the beginning of a sentence, where it cannot be made.
class PassingFolder {
 public:
  explicit PassingFolder(const std::string& purpose);
  PassingFolder(PassingFolder&& other) noexcept : path_(std::move(other.path_))
  {
    other.path_.clear();
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  ~PassingFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace encased_column
