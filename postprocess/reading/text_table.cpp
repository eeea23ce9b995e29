// SPDX-License-Identifier: GPL-2.0-only
#include "reading/text_table.h"

#include "core/input_error.h"

#include <vtkDelimitedTextReader.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <fstream>

namespace encased_column {

namespace {

std::string without_comments(const std::filesystem::path& file)
{
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file))
    throw InputError("a table must be a file that can be read, found '" + file.string() +
                     "', check its name and that the run has written it");
  std::string text, line;
  while (std::getline(stream, line)) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty() && line.front() != '#') text += line + '\n';
  }
  return text;
}

}  // namespace

TextTable::TextTable(const std::filesystem::path& file) : file_(file)
{
  const std::string text = without_comments(file);
  vtkNew<vtkDelimitedTextReader> reader;
  reader->SetInputString(text);
  reader->ReadFromInputStringOn();
  reader->SetHaveHeaders(true);
  reader->DetectNumericColumnsOff();
  reader->SetFieldDelimiterCharacters(",");
  if (text.find('\n') + 1 < text.size()) reader->Update();
  vtkTable* table = reader->GetOutput();

  rows_ = table->GetNumberOfRows();
  bool cut_off = false;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i) {
    auto* words = vtkStringArray::SafeDownCast(table->GetColumn(i));
    if (!words) continue;
    std::vector<std::string>& column = columns_[words->GetName()];
    for (std::size_t row = 0; row < rows_; ++row) column.push_back(words->GetValue(row));
    if (rows_ > 0 && i + 1 == table->GetNumberOfColumns()) cut_off = column.back().empty();
  }
  if (cut_off) {
    --rows_;
    for (auto& [name, column] : columns_) column.pop_back();
  }
  if (rows_ == 0)
    throw InputError("a table must hold a line of headings and one row at least, found none in '" +
                     file.string() + "', let the run get as far as its shear stage");
}

bool TextTable::has(const std::string& column) const
{
  return columns_.count(column) > 0;
}

std::vector<std::string> TextTable::headings() const
{
  std::vector<std::string> headings;
  for (const auto& [name, words] : columns_) headings.push_back(name);
  return headings;
}

const std::vector<std::string>& TextTable::words(const std::string& column) const
{
  const auto found = columns_.find(column);
  if (found == columns_.end())
    throw InputError("'" + file_.string() + "' must have a column '" + column +
                     "', found none of that name and unit, write the file with the same version");
  return found->second;
}

std::vector<double> TextTable::numbers(const std::string& column) const
{
  std::vector<double> numbers;
  numbers.reserve(rows_);
  for (const std::string& word : words(column)) try {
      numbers.push_back(read_number(column, word));
    } catch (const InputError&) {
      throw InputError("column '" + column + "' of '" + file_.string() +
                       "' takes finite numbers, found '" + word + "' in row " +
                       std::to_string(numbers.size() + 1) + ", run the case again");
    }
  return numbers;
}

}  // namespace encased_column
