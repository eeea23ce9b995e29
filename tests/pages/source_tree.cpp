// SPDX-License-Identifier: GPL-2.0-only
#include "pages/source_tree.h"

#include <string>

namespace encased_column::testing {

namespace fs = std::filesystem;

std::vector<fs::path> files_of_tree(const fs::path& source)
{
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator entry(source), end; entry != end; ++entry) {
    const std::string name = entry->path().filename();
    const bool is_made = entry.depth() == 0 && (name.rfind("build", 0) == 0 || name == "runs");
    if (entry->is_directory() && (name.front() == '.' || is_made))
      entry.disable_recursion_pending();
    else if (entry->is_regular_file())
      files.push_back(entry->path());
  }
  return files;
}

}  // namespace encased_column::testing
