#include "files/vtk_contacts_writer.h"

#include "files/vtk_file.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace encased_column {

namespace {

using Contacts = std::vector<ContactRecord>;

void add_lines(vtkPolyData* data, const Contacts& contacts)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  points->SetNumberOfPoints(2 * static_cast<vtkIdType>(contacts.size()));
  vtkIdType ends[2] = {0, 1};
  for (const ContactRecord& contact : contacts) {
    points->SetPoint(ends[0], contact.from.data());
    points->SetPoint(ends[1], contact.to.data());
    lines->InsertNextCell(2, ends);
    for (vtkIdType& end : ends) end += 2;
  }
  data->SetPoints(points);
  data->SetLines(lines);
}

void add_integers(vtkPolyData* data, const char* name, const Contacts& contacts,
                  int ContactRecord::*field)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(contacts.size()));
  vtkIdType n = 0;
  for (const ContactRecord& contact : contacts) array->SetValue(n++, contact.*field);
  data->GetCellData()->AddArray(array);
}

}  // namespace

bool write_contacts(const std::string& path, const Contacts& contacts)
{
  vtkNew<vtkPolyData> data;
  add_lines(data, contacts);
  const int count = static_cast<int>(contacts.size());
  add_array<1>(data->GetPointData(), "force [N]", 2 * count,
               [&](int point) { return contacts[point / 2].force; });
  add_array<1>(data->GetCellData(), "normal_force [N]", count,
               [&](int n) { return contacts[n].normal_force; });
  add_array<1>(data->GetCellData(), "shear_force [N]", count,
               [&](int n) { return contacts[n].shear_force; });
  add_integers(data, "kind [-]", contacts, &ContactRecord::kind);
  add_integers(data, "sliding [-]", contacts, &ContactRecord::sliding);
  return write_poly_data(path, data);
}

}  // namespace encased_column
