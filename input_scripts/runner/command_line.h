// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "report_command.h"
#include "runner/run_options.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace encased_column {

/// All subcommands of `encase` and their options: what reads them, the pages of `man` and the
/// completion of the shells are made from the same data.
struct CommandLine {
  CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// Adds --version, which prints what `text` gives.
  void add_version(std::function<std::string()> text);

  /// The subcommand that was given.
  std::string command() const;

  CLI::App app;
  RunOptions run;  ///< of `run` and `list`
  ReportOptions report;
  std::vector<std::string> word;  ///< of `explain`
  std::string folder;             ///< of `texts`
};

/// One sentence for what is wrong with `words`, those of the command line without the program.
std::string in_one_sentence(const CLI::ParseError& problem, const CLI::App& app,
                            const std::vector<std::string>& words);

}  // namespace encased_column
