// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/places.h"

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace encased_column {

/// What the user asks of `encase report`.
struct ReportOptions {
  std::vector<std::filesystem::path> folders;
  std::filesystem::path targets, output;
  std::string platen;  ///< empty: mean of plain tests, bottom of encased ones
  bool no_pictures = false;
  bool draft = false;
  bool strict = false;
  bool brief = false;          ///< the screen gets three sentences, tables go to files alone
  bool pictures_only = false;  ///< set when started again under a virtual display
};

void add_report_options(CLI::App& command, ReportOptions& options);

/// `encase report`: the exit code. `arguments` are those of the program, which is started again
/// with them where pictures take a display. Throws InputError for input that cannot be used.
int report_command(ReportOptions options, const Places& places,
                   const std::vector<std::string>& arguments);

}  // namespace encased_column
