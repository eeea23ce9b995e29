// SPDX-License-Identifier: GPL-2.0-only
#include "runner/shell_texts.h"

#include "runner/completion.h"
#include "runner/manual_page.h"
#include "runner/style_catalogue.h"
#include "runner/text_file.h"
#include "runner/visible_commands.h"

namespace encased_column {

void write_shell_texts(const CommandLine& line, const std::filesystem::path& folder)
{
  const std::string version = std::string("version ") + ENCASE_VERSION;
  std::filesystem::create_directories(folder);
  write_text_file(folder / "encase.1", manual_page(line.app, "encase", version));
  for (const CLI::App* command : visible_commands(line.app)) {
    const std::string name = command->get_name();
    write_text_file(folder / ("encase-" + name + ".1"),
                    manual_page(*command, "encase " + name, version));
  }
  write_text_file(folder / "liggghts-encase.1", manual_page_of_host(style_pages(), version));
  write_text_file(folder / "encase", bash_completion(line.app));
  write_text_file(folder / "_encase", zsh_completion(line.app));
}

}  // namespace encased_column
