#include "files/vtk_file.h"

#include "files/atomic_file.h"

#include <vtkErrorCode.h>
#include <vtkObject.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

namespace encased_column {

bool write_poly_data(const std::string& path, vtkPolyData* data, bool compress)
{
  vtkObject::GlobalWarningDisplayOff();  // the caller says what went wrong, once
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(unfinished(path).c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  if (compress)
    writer->SetCompressorTypeToZLib();
  else
    writer->SetCompressorTypeToNone();
  const bool written = writer->Write() == 1 && writer->GetErrorCode() == vtkErrorCode::NoError;
  return written && finish_file(path);
}

}  // namespace encased_column
