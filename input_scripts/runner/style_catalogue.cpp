// SPDX-License-Identifier: GPL-2.0-only
#include "runner/style_catalogue.h"

#include "runner/aligned_text.h"

#include <cstdlib>
#include <sstream>

namespace encased_column {

namespace {

bool starts_with(const std::string& text, const std::string& start)
{
  return text.rfind(start, 0) == 0;
}

std::string trimmed_cell(const std::string& text)
{
  const auto from = text.find_first_not_of(' '), to = text.find_last_not_of(' ');
  return from == std::string::npos ? "" : text.substr(from, to - from + 1);
}

/// The cells of "| `name` | 1 | m | meaning |"; backquotes around the name go.
std::vector<std::string> cells_of(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream parts(line.substr(1));
  for (std::string cell; std::getline(parts, cell, '|');) cells.push_back(trimmed_cell(cell));
  std::string& name = cells.front();
  if (name.size() > 1 && name.front() == '`') name = name.substr(1, name.size() - 2);
  return cells;
}

std::string short_name(const std::string& name)
{
  return starts_with(name, "fix ") ? name.substr(4) : name;
}

std::string values_in_words(int values)
{
  return values == 0 ? "no value" : std::to_string(values) + (values == 1 ? " value" : " values");
}

const PageStart* page_of(const std::string& style, const std::vector<PageStart>& pages)
{
  for (const PageStart& page : pages)
    if (style == page.name) return &page;
  return nullptr;
}

}  // namespace

std::vector<StyleText> read_styles(const std::string& printed, const std::vector<PageStart>& pages)
{
  std::vector<StyleText> styles;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    if (starts_with(line, "|") && !styles.empty()) {
      std::vector<StyleTable>& tables = styles.back().tables;
      const std::vector<std::string> cells = cells_of(line);
      if (tables.empty() && cells.size() >= 4)
        styles.back().keywords.push_back(
            {cells[0], std::atoi(cells[1].c_str()), cells[2], cells[3]});
      else if (!tables.empty() && cells.size() >= 3)
        tables.back().columns.push_back({cells[0], 0, cells[1], cells[2]});
    } else if (starts_with(line, "table ") && !styles.empty()) {
      styles.back().tables.push_back({line.substr(6), {}});
    } else {
      styles.push_back({starts_with(line, "command ") ? line.substr(8) : line, "", "", {}, {}});
    }
  }
  for (StyleText& style : styles)
    if (const PageStart* page = page_of(style.name, pages)) {
      style.summary = page->summary;
      style.page = page->file;
    }
  for (const PageStart& page : pages)
    if (!find_style(styles, page.name))
      styles.push_back({page.name, page.summary, page.file, {}, {}});
  return styles;
}

std::string list_of_styles(const std::vector<StyleText>& styles)
{
  std::vector<std::vector<std::string>> rows;
  for (const StyleText& style : styles) rows.push_back({style.name, style.summary});
  return aligned(rows);
}

std::string description(const StyleText& style)
{
  std::string text = style.name + "\n";
  if (!style.summary.empty()) text += style.summary + "\n";
  std::vector<std::vector<std::string>> rows;
  for (const StyleRow& row : style.keywords)
    rows.push_back(
        {"  " + row.name, values_in_words(row.values), "[" + row.unit + "]", row.meaning});
  if (!rows.empty()) text += "\nKeywords:\n" + aligned(rows);
  for (const StyleTable& table : style.tables) {
    rows.clear();
    for (const StyleRow& row : table.columns)
      rows.push_back({"  " + row.name, "[" + row.unit + "]", row.meaning});
    text += "\nColumns of " + table.file + ":\n" + aligned(rows);
  }
  if (!style.page.empty()) text += "\nPage with examples: " + style.page + "\n";
  return text;
}

const StyleText* find_style(const std::vector<StyleText>& styles, const std::string& name)
{
  for (const StyleText& style : styles)
    if (style.name == name || short_name(style.name) == name) return &style;
  return nullptr;
}

std::string uses_of(const std::vector<StyleText>& styles, const std::string& name)
{
  std::vector<std::vector<std::string>> rows;
  for (const StyleText& style : styles) {
    for (const StyleRow& row : style.keywords)
      if (row.name == name)
        rows.push_back({"keyword of " + style.name, values_in_words(row.values),
                        "[" + row.unit + "]", row.meaning});
    for (const StyleTable& table : style.tables)
      for (const StyleRow& row : table.columns)
        if (row.name == name)
          rows.push_back({"column of " + table.file + ", " + style.name, "", "[" + row.unit + "]",
                          row.meaning});
  }
  return rows.empty() ? "" : aligned(rows);
}

std::vector<std::string> words_of(const std::vector<StyleText>& styles)
{
  std::vector<std::string> words;
  for (const StyleText& style : styles) {
    words.push_back(style.name);
    if (short_name(style.name) != style.name) words.push_back(short_name(style.name));
    for (const StyleRow& row : style.keywords) words.push_back(row.name);
    for (const StyleTable& table : style.tables)
      for (const StyleRow& row : table.columns) words.push_back(row.name);
  }
  return words;
}

}  // namespace encased_column
