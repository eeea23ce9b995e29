// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "support/child_program.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace encased_column::testing {

/// What one file holds, read with the library that ParaView reads it with; single precision.
class VtpFile {
 public:
  explicit VtpFile(const std::filesystem::path& file)
  {
    if (!std::filesystem::exists(file)) throw std::runtime_error("no file " + file.string());
    reader_->SetFileName(file.c_str());
    reader_->Update();
  }
  vtkPolyData* data() const { return reader_->GetOutput(); }

  /// An array with one number for each point.
  std::vector<double> of_points(const char* name) const
  {
    return numbers(data()->GetPointData()->GetArray(name), name);
  }
  /// An array with one number for each cell.
  std::vector<double> of_cells(const char* name) const
  {
    return numbers(data()->GetCellData()->GetArray(name), name);
  }
  std::vector<double> point(int n) const
  {
    std::vector<double> x(3);
    data()->GetPoint(n, x.data());
    return x;
  }

 private:
  static std::vector<double> numbers(vtkDataArray* array, const char* name)
  {
    if (!array) throw std::runtime_error(std::string("no array ") + name);
    std::vector<double> all;
    for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n) all.push_back(array->GetTuple1(n));
    return all;
  }

  vtkNew<vtkXMLPolyDataReader> reader_;
};

/// The attribute `name` of every DataSet of a ParaView collection.
inline std::vector<std::string> listed_in(const std::filesystem::path& file,
                                          const std::string& name = "file")
{
  std::vector<std::string> found;
  const std::string text = read_text(file), before = " " + name + "=\"", entry = "<DataSet";
  for (auto at = text.find(entry); at != std::string::npos; at = text.find(entry, at + 1)) {
    const auto begin = text.find(before, at) + before.size();
    found.push_back(text.substr(begin, text.find('"', begin) - begin));
  }
  return found;
}

}  // namespace encased_column::testing
