// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column::testing {

/// A new, empty folder that goes with this object; a failed test keeps it and says where it is.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// How a program ended and all it wrote to the screen.
struct Outcome {
  int exit_code;  ///< 128 + signal for a program that was killed
  std::string output;

  /// The lines of the output, without blanks around them.
  std::vector<std::string> lines() const;
  bool says(const std::string& sentence) const
  {
    return output.find(sentence) != std::string::npos;
  }
  /// The number after the first `name` that starts a line ("porosity 0.4"); not a number without.
  double value(const std::string& name) const;
};

/// Runs `words` in `folder` and waits.
Outcome run_program(const std::vector<std::string>& words, const std::filesystem::path& folder);

/// Runs the deck `text` in `folder`, on `ranks` MPI ranks (more than there are cores is possible).
Outcome run_deck(const std::string& text, int ranks, const std::filesystem::path& folder,
                 const std::vector<std::string>& arguments = {});
/// The same in a folder of its own.
Outcome run_deck(const std::string& text, int ranks = 1);

/// The whole of a text file; throws std::runtime_error when it cannot be read.
std::string read_text(const std::filesystem::path& file);

/// The deck tests/pages/openings/NAME.lmp, which others continue.
std::string opening_deck(const std::string& name);

}  // namespace encased_column::testing
