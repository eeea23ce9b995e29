#include "runner/scratch_folder.h"

#include "core/input_error.h"

#include <cstdlib>

namespace encased_column {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder(const std::string& name)
{
  std::string folder = (fs::temp_directory_path() / (name + "_XXXXXX")).string();
  if (!mkdtemp(folder.data()))
    throw InputError("temporary files must go where folders can be made, found that '" + folder +
                     "' cannot, write another TMPDIR");
  path_ = folder;
}

ScratchFolder::~ScratchFolder()
{
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace encased_column
