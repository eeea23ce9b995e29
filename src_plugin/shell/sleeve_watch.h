// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/height_window.h"
#include "shell/shell_model.h"

#include <array>
#include <string>
#include <vector>

namespace encased_column {

/// What the log is to be told of a sleeve, each thing once.
class SleeveWatch {
 public:
  /// A platen beyond its end of the sleeve, where grains can escape. Nodes and platens (top,
  /// bottom).
  void look_at_ends(const ShellModel& model, const std::vector<int> (&end_nodes)[2],
                    const HeightWindow& window, const std::string& id,
                    const std::array<std::string, 2>& platens, long step,
                    std::vector<std::string>& sentences);
  /// A tension above the strength of a cloth that bears more, or above the last reading of its
  /// strip test.
  void look_at_strength(const ShellModel& model, const std::string& id, long step,
                        std::vector<std::string>& sentences);

 private:
  bool platen_told_[2] = {false, false}, strength_told_[2] = {false, false};
};

}  // namespace encased_column
