// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// A row of a table that a style has: a keyword, or a column of a CSV file that it writes.
struct StyleRow {
  std::string name;
  int values = 0;  ///< words that follow a keyword; of a column none
  std::string unit, meaning;
};

/// A CSV file that a style writes.
struct StyleTable {
  std::string file;
  std::vector<StyleRow> columns;
};

/// What the plugin knows of one of its styles.
struct StyleText {
  std::string name;     ///< as a deck writes it: "fix servo/platen", "solve"
  std::string summary;  ///< first sentence of its page; empty without one
  std::string page;     ///< file of it below the folder of the pages
  std::vector<StyleRow> keywords;
  std::vector<StyleTable> tables;
};

/// The first lines of a user page.
struct PageStart {
  const char* name;  ///< its title, which is the style's name
  const char* summary;
  const char* file;
};

/// The pages of all styles; made from them when the program is built.
const std::vector<PageStart>& style_pages();

/// The styles as `liggghts-encase -styles` prints them, with the start of their page from `pages`;
/// a page whose style has no keyword table, as the contact law, stands behind them.
std::vector<StyleText> read_styles(const std::string& printed, const std::vector<PageStart>& pages);

/// One line a style.
std::string list_of_styles(const std::vector<StyleText>& styles);

/// All that is known of one style, for reading.
std::string description(const StyleText& style);

/// The style called `name`, with or without "fix " before it; none: nullptr.
const StyleText* find_style(const std::vector<StyleText>& styles, const std::string& name);

/// A line for each style that has the keyword or column `name`; empty where none has.
std::string uses_of(const std::vector<StyleText>& styles, const std::string& name);

/// Names of all styles, with and without "fix ", keywords and columns.
std::vector<std::string> words_of(const std::vector<StyleText>& styles);

}  // namespace encased_column
