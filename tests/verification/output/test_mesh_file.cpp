// SPDX-License-Identifier: GPL-2.0-only
// Mesh files written here, byte by byte, and read back as the surface they hold.
#include "files/mesh_file.h"

#include "core/input_error.h"
#include "shell/surface_mesh.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <fstream>

using namespace encased_column;
using encased_column::testing::TemporaryFolder;

namespace {

/// Two triangles that share the side from (1, 0, 0) to (0, 2, 0).
const std::array<std::array<Vec3, 3>, 2> triangles{
    {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 2, 0)}, {Vec3(1, 0, 0), Vec3(1, 2, 3), Vec3(0, 2, 0)}}};

class MeshFile : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text)
  {
    const std::string path = folder_.path() / name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  /// The sentence with which a file is refused.
  std::string refusal(const std::string& path)
  {
    try {
      read_mesh_file(path);
    } catch (const InputError& problem) {
      return problem.what();
    }
    return "not refused";
  }

  TemporaryFolder folder_;
};

void expect_the_triangles(const std::vector<std::array<Vec3, 3>>& corners)
{
  const SurfaceMesh mesh = welded(corners);
  EXPECT_EQ(mesh.node.size(), 4u) << "the two triangles share their side";
  ASSERT_EQ(mesh.facet.size(), 2u);
  for (int f = 0; f < 2; ++f)
    for (int i = 0; i < 3; ++i)
      EXPECT_LT((mesh.node[mesh.facet[f][i]] - triangles[f][i]).norm(), 1e-6);
}

template <typename Number>
void append(std::string& bytes, Number number)
{
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

const std::string four_points = "4 float\n0 0 0 1 0 0 0 2 0 1 2 3\n";

std::string vtk_text(const std::string& cells)
{
  return "# vtk DataFile Version 3.0\nsleeve\nASCII\nDATASET POLYDATA\nPOINTS " + four_points +
         cells;
}

}  // namespace

TEST_F(MeshFile, OfStlInTextIsRead)
{
  std::string text = "solid two\n";
  for (const auto& triangle : triangles) {
    text += "facet normal 0 0 1\nouter loop\n";
    for (const Vec3& c : triangle)
      text += "vertex " + std::to_string(c.x()) + " " + std::to_string(c.y()) + " " +
              std::to_string(c.z()) + "\n";
    text += "endloop\nendfacet\n";
  }
  expect_the_triangles(read_mesh_file(write("two.stl", text + "endsolid two\n")));
}

TEST_F(MeshFile, OfBinaryStlIsRead)
{
  std::string bytes(80, ' ');
  append<std::uint32_t>(bytes, 2);
  for (const auto& triangle : triangles) {
    for (int n = 0; n < 3; ++n) append(bytes, 0.0f);
    for (const Vec3& c : triangle)
      for (int a = 0; a < 3; ++a) append(bytes, static_cast<float>(c(a)));
    append<std::uint16_t>(bytes, 0);
  }
  expect_the_triangles(read_mesh_file(write("two.stl", bytes)));
}

TEST_F(MeshFile, OfVtkIsRead)
{
  expect_the_triangles(
      read_mesh_file(write("two.vtk", vtk_text("POLYGONS 2 8\n3 0 1 2\n3 1 3 2\n"))));
}

TEST_F(MeshFile, OfVtkXmlIsRead)
{
  expect_the_triangles(read_mesh_file(write(
      "two.vtp",
      "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData>\n"
      "<Piece NumberOfPoints=\"4\" NumberOfPolys=\"2\"><Points>\n"
      "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n"
      "0 0 0 1 0 0 0 2 0 1 2 3</DataArray></Points><Polys>\n"
      "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 1 3 2</DataArray>\n"
      "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 6</DataArray>\n"
      "</Polys></Piece></PolyData></VTKFile>\n")));
}

TEST_F(MeshFile, TurnsAQuadrilateralIntoTwoTriangles)
{
  const SurfaceMesh mesh =
      welded(read_mesh_file(write("four.vtk", vtk_text("POLYGONS 1 5\n4 0 1 3 2\n"))));
  EXPECT_EQ(mesh.facet.size(), 2u);
  EXPECT_EQ(mesh.node.size(), 4u);
}

TEST_F(MeshFile, IsRefusedWhereItIsNotThere)
{
  EXPECT_EQ(refusal("nowhere.stl"),
            "'file' must be a file that can be read, found 'nowhere.stl', write the path as seen "
            "from where the run starts");
}

TEST_F(MeshFile, IsRefusedInAnotherFormat)
{
  EXPECT_EQ(refusal(write("two.obj", "v 0 0 0\n")).find("'file' must end in .stl, .vtk or .vtp"),
            0u);
}

TEST_F(MeshFile, IsRefusedWithoutTriangles)
{
  const std::string path = write("lines.vtk", vtk_text("LINES 1 3\n2 0 1\n"));
  EXPECT_EQ(refusal(path).find("'file' must hold triangles, found none in '" + path), 0u)
      << refusal(path);
}

TEST_F(MeshFile, IsRefusedWhereItIsNotOfItsFormat)
{
  for (const std::string& path : {write("words.stl", "hello\n"), write("empty.stl", ""),
                                  write("words.vtp", "hello\n"), write("words.vtk", "hello\n")})
    EXPECT_EQ(refusal(path).find("'file' must be a whole file of its format, found one that is cut "
                                 "off or damaged in '" +
                                 path),
              0u)
        << refusal(path);
}

TEST_F(MeshFile, IsRefusedWithACoordinateThatIsNoNumber)
{
  const std::string path =
      write("nan.stl",
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex nan 0 0\nvertex 0 1 0\n"
            "endloop\nendfacet\nendsolid a\n");
  EXPECT_NE(refusal(path), "not refused");
}
