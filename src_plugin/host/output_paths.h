// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// Who writes which file of a run. Two writers of one file would mix their rows, or each destroy
/// what the other wrote, without a word.
class OutputPaths {
 public:
  /// Notes that `owner` writes the absolute `path`. Where the file has an owner already, under this
  /// or another name of it, returns that one and notes nothing; empty where it is free. An owner
  /// that `repeats` may write its own file again.
  std::string claim(const std::string& path, const std::string& owner, bool repeats = false);
  void release(const std::string& owner);

 private:
  struct Claim {
    std::string path, owner;
  };
  std::vector<Claim> claims_;
};

/// `path` from the root, whatever folder the process goes to later.
std::string absolute_path(const std::string& path);

/// True where both name one file, by links and other ways round too, or would if it were made.
bool is_same_file(const std::string& one, const std::string& other);

/// True where this process holds the file open to write into it.
bool is_open_for_writing(const std::string& path);

}  // namespace encased_column
