// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// How the first line of a CSV file calls a column: "height [m]".
struct ColumnName {
  const char* name;
  const char* unit;

  std::string heading() const { return std::string(name) + " [" + unit + "]"; }
  operator std::string() const { return heading(); }
};

/// One column of a table whose rows are made of a Row: how it is called, what the user page says of
/// it, and where its number comes from.
template <typename Row>
struct Column {
  ColumnName name;
  const char* meaning;
  double (*value)(const Row&);
};

/// What a user page lists of a column.
struct ColumnText {
  std::string name, unit, meaning;
};

/// A CSV file of a style, by its usual name, and its columns in their order.
struct TableText {
  std::string file;
  std::vector<ColumnText> columns;
};

template <typename Row>
std::vector<std::string> headings_of(const std::vector<Column<Row>>& columns)
{
  std::vector<std::string> headings;
  for (const Column<Row>& column : columns) headings.push_back(column.name);
  return headings;
}

template <typename Row>
std::vector<ColumnText> texts_of(const std::vector<Column<Row>>& columns)
{
  std::vector<ColumnText> texts;
  for (const Column<Row>& column : columns)
    texts.push_back({column.name.name, column.name.unit, column.meaning});
  return texts;
}

/// The numbers of `row`, added to what `numbers` holds.
template <typename Row>
void add_numbers(const std::vector<Column<Row>>& columns, const Row& row,
                 std::vector<double>& numbers)
{
  for (const Column<Row>& column : columns) numbers.push_back(column.value(row));
}

}  // namespace encased_column
