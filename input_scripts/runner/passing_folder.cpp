// SPDX-License-Identifier: GPL-2.0-only
#include "runner/passing_folder.h"

#include "core/input_error.h"

#include <cstdlib>

namespace encased_column {

namespace fs = std::filesystem;

PassingFolder::PassingFolder(const std::string& purpose)
{
  std::string name = (fs::temp_directory_path() / "encase_XXXXXX").string();
  if (!mkdtemp(name.data()))
    throw InputError(purpose + " in a folder of its own, found that '" + name +
                     "' cannot be made, write another TMPDIR");
  path_ = name;
}

PassingFolder::~PassingFolder()
{
  if (path_.empty()) return;
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace encased_column
