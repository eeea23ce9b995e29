// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/picture_data.h"

#include <vtkBase64Utilities.h>
#include <vtkImageData.h>
#include <vtkImageResize.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace encased_column {

namespace {

std::string base64(vtkUnsignedCharArray* bytes)
{
  const auto count = static_cast<unsigned long>(bytes->GetNumberOfValues());
  std::string text(4 * (count / 3 + 1), '\0');
  text.resize(vtkBase64Utilities::Encode(bytes->GetPointer(0), count,
                                         reinterpret_cast<unsigned char*>(text.data())));
  return text;
}

}  // namespace

PictureData picture_data(const std::filesystem::path& file, int width)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  const int* size = reader->GetOutput()->GetDimensions();
  const int new_width = std::min(width, size[0]);
  const int new_height = size[1] * new_width / size[0];
  vtkNew<vtkImageResize> smaller;
  smaller->SetInputConnection(reader->GetOutputPort());
  smaller->SetOutputDimensions(new_width, new_height, 1);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(smaller->GetOutputPort());
  writer->SetCompressionLevel(9);
  writer->WriteToMemoryOn();
  writer->Write();
  return {base64(writer->GetResult()), new_width, new_height};
}

}  // namespace encased_column
