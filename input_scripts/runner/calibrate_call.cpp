// SPDX-License-Identifier: GPL-2.0-only
#include "runner/calibrate_call.h"

#include "core/input_error.h"
#include "runner/text_file.h"

#include <unistd.h>

#include <filesystem>

namespace encased_column {

void call_calibrate(const std::vector<std::string>& words)
{
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "encase-calibrate";
  std::vector<std::string> all{program};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  for (std::string& word : all) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execv(program.c_str(), pointers.data());
  throw InputError(
      "it needs the program 'encase-calibrate', which is built where libopenturns-dev, "
      "libyaml-cpp-dev, libsqlitecpp-dev and libfann-dev are installed, found none in '" +
      shown(program.parent_path()) +
      "', write './calibration/run CONFIG' in the folder "
      "of the project, which sets up what is missing, or install the Debian package "
      "'encased-columns-calibration'");
}

}  // namespace encased_column
