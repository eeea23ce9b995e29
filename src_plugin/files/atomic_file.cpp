// SPDX-License-Identifier: GPL-2.0-only
#include "files/atomic_file.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace encased_column {

std::string unfinished(const std::string& path)
{
  return path + ".part";
}

bool finish_file(const std::string& path)
{
  std::error_code failure;
  std::filesystem::rename(unfinished(path), path, failure);
  return !failure;
}

bool write_whole_file(const std::string& path, const std::string& text)
{
  std::ofstream file(unfinished(path), std::ios::binary);
  file << text;
  file.close();
  return file.good() && finish_file(path);
}

}  // namespace encased_column
