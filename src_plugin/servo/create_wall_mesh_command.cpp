// SPDX-License-Identifier: GPL-2.0-only
#include "servo/create_wall_mesh_command.h"

#include "core/input_error.h"
#include "host/output_files.h"
#include "servo/wall_mesh.h"

#include <vtkCellArray.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>

#include <string>

namespace encased_column {

const KeywordTable CreateWallMeshCommand::keywords{
    {"file", 1, "-", "STL file to write"},
    {"shape", 1, "-", "cylinder or square"},
    {"radius", 1, "m", "radius of the cylinder's nodes, larger than zero"},
    {"z_low", 1, "m", "lower end of the cylinder"},
    {"z_high", 1, "m", "upper end of the cylinder, larger than z_low"},
    {"half_width", 1, "m", "half the side of the square, larger than zero"},
    {"z", 1, "m", "level of the square"},
    {"edge", 1, "m", "wanted edge length, at most radius, height or width"},
    {"format", 1, "-", "ascii (default, all digits) or binary (seven digits)"},
};

namespace {

void refuse_keywords_of_the_other_shape(const Options& options, const std::string& shape)
{
  const std::vector<std::string> foreign =
      shape == "cylinder" ? std::vector<std::string>{"half_width", "z"}
                          : std::vector<std::string>{"radius", "z_low", "z_high"};
  for (const std::string& keyword : foreign)
    if (options.has(keyword))
      throw InputError("keyword '" + keyword + "' does not belong to 'shape " + shape +
                       "', found '" + keyword + " " + options.word(keyword) + "', leave it out");
}

SurfaceMesh mesh_of(const Options& options)
{
  const std::string shape = options.choice("shape", {"cylinder", "square"});
  refuse_keywords_of_the_other_shape(options, shape);
  if (shape == "cylinder")
    return cylinder_mesh(CylinderWall{options.number("radius"), options.number("z_low"),
                                      options.number("z_high"), options.number("edge")});
  return square_mesh({options.number("half_width"), options.number("z"), options.number("edge")});
}

/// True when the whole file was written.
bool write_stl(const SurfaceMesh& mesh, const std::string& file, bool binary)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& node : mesh.node) points->InsertNextPoint(node.data());
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : mesh.facet)
    cells->InsertNextCell({triangle[0], triangle[1], triangle[2]});
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(cells);

  vtkObject::GlobalWarningDisplayOff();  // the one sentence of the adapter says it
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileName(file.c_str());
  binary ? writer->SetFileTypeToBinary() : writer->SetFileTypeToASCII();
  writer->Write();
  return writer->GetErrorCode() == vtkErrorCode::NoError;
}

}  // namespace

void CreateWallMeshCommand::command(int narg, char** arg)
{
  try {
    const Options options = keywords.read(narg, arg, 0);
    const std::string file = options.word("file");
    const bool binary = options.choice("format", {"ascii", "binary"}, "ascii") == "binary";
    const SurfaceMesh mesh = mesh_of(options);
    OutputFiles files(lmp, "create_wall_mesh");
    const std::string path = files.claim("file", file);

    int written = comm->me != 0 || write_stl(mesh, path, binary);
    // also the barrier behind which every rank may read the file
    MPI_Bcast(&written, 1, MPI_INT, 0, world);
    if (!written)
      throw InputError("'file' must be a path that can be written, found '" + file +
                       "', write one whose folder exists and has room");
    if (comm->me == 0) {
      const std::string report = "Wall mesh " + file + ": " + std::to_string(mesh.node.size()) +
                                 " nodes, " + std::to_string(mesh.facet.size()) + " triangles\n";
      if (screen) std::fputs(report.c_str(), screen);
      if (logfile) std::fputs(report.c_str(), logfile);
    }
  } catch (const InputError& problem) {
    error->all(FLERR, problem.what());
  }
}

}  // namespace encased_column
