// SPDX-License-Identifier: GPL-2.0-only
#include "host/output_paths.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>

namespace encased_column {

namespace fs = std::filesystem;

std::string OutputPaths::claim(const std::string& path, const std::string& owner, bool repeats)
{
  for (const Claim& claim : claims_)
    if (!(repeats && claim.owner == owner) && is_same_file(claim.path, path)) return claim.owner;
  claims_.push_back({path, owner});
  return "";
}

void OutputPaths::release(const std::string& owner)
{
  claims_.erase(std::remove_if(claims_.begin(), claims_.end(),
                               [&](const Claim& claim) { return claim.owner == owner; }),
                claims_.end());
}

std::string absolute_path(const std::string& path)
{
  return fs::absolute(path).string();
}

bool is_same_file(const std::string& one, const std::string& other)
{
  std::error_code failure;
  if (fs::equivalent(one, other, failure)) return true;
  const fs::path first = fs::weakly_canonical(one, failure);
  return !failure && first == fs::weakly_canonical(other, failure) && !failure;
}

bool is_open_for_writing(const std::string& path)
{
  struct stat wanted {};
  if (stat(path.c_str(), &wanted) != 0 || !S_ISREG(wanted.st_mode)) return false;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator("/proc/self/fd", failure)) {
    const int descriptor = std::atoi(entry.path().filename().c_str());
    struct stat open_file {};
    if (fstat(descriptor, &open_file) != 0) continue;
    const bool same = open_file.st_dev == wanted.st_dev && open_file.st_ino == wanted.st_ino;
    if (same && (fcntl(descriptor, F_GETFL) & O_ACCMODE) != O_RDONLY) return true;
  }
  return false;
}

}  // namespace encased_column
