// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace encased_column::testing {

/// A style as the program prints it with -styles.
struct ListedStyle {
  std::string title;  ///< "fix NAME", or "NAME" of a command: the title of its page
  std::vector<std::string> keywords;
  std::vector<std::string> files;  ///< CSV files that it writes, by their usual names
};

/// What `liggghts-encase -styles` prints, in its order.
std::vector<ListedStyle> listed_styles(const std::vector<std::string>& lines);

/// The page src_plugin/STYLES.md: a row for each style of the program and for each other page that
/// is titled as the deck writes it, in the folders' order, with the first paragraph of its page.
/// `pages` are those of src_plugin/*/, `table` is the text of style_table.cpp.
std::string style_index(const std::vector<ListedStyle>& styles,
                        const std::vector<std::filesystem::path>& pages, const std::string& table);

}  // namespace encased_column::testing
