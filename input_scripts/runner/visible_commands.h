// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <CLI/CLI.hpp>

#include <vector>

namespace encased_column {

/// The commands of `app` that its users are told of.
inline std::vector<const CLI::App*> visible_commands(const CLI::App& app)
{
  std::vector<const CLI::App*> commands;
  for (const CLI::App* command : app.get_subcommands({}))
    if (!command->get_group().empty()) commands.push_back(command);
  return commands;
}

}  // namespace encased_column
