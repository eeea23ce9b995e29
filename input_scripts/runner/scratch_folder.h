#pragma once

#include <filesystem>
#include <string>

namespace encased_column {

/// A new, empty folder among the temporary files, which goes with this object.
class ScratchFolder {
 public:
  /// Throws InputError where none can be made.
  explicit ScratchFolder(const std::string& name);
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace encased_column
