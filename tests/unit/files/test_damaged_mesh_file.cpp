// SPDX-License-Identifier: GPL-2.0-only
// Mesh files of every format, cut off and with one byte changed: the same mesh, one that can be
// used, or one sentence. Instrumented (tests/run --sanitize) no byte is read outside of them.
#include "core/input_error.h"
#include "files/mesh_file.h"
#include "shell/cylinder_mesh.h"
#include "shell/surface_mesh.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSTLWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <random>

using namespace encased_column;
using encased_column::testing::TemporaryFolder;

namespace {

using Triangles = std::vector<std::array<Vec3, 3>>;

class DamagedMeshFile : public ::testing::Test {
 protected:
  /// A tube as every format that VTK writes of it: names and bytes.
  std::map<std::string, std::string> files_of(const SurfaceMesh& tube)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec3& node : tube.node) points->InsertNextPoint(node.data());
    vtkNew<vtkCellArray> cells;
    for (const Facet& facet : tube.facet) cells->InsertNextCell({facet[0], facet[1], facet[2]});
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(points);
    surface->SetPolys(cells);
    std::map<std::string, std::string> files;
    const auto keep = [&](const std::string& name, auto& writer) {
      const std::string path = folder_.path() / name;
      writer.SetInputData(surface);
      writer.SetFileName(path.c_str());
      writer.Write();
      files[name] = encased_column::testing::read_text(path);
    };
    vtkNew<vtkSTLWriter> stl;
    stl->SetFileTypeToASCII();
    keep("text.stl", *stl);
    stl->SetFileTypeToBinary();
    keep("bytes.stl", *stl);
    vtkNew<vtkPolyDataWriter> vtk;
    keep("text.vtk", *vtk);
    vtk->SetFileVersion(vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_4_2);
    keep("old_text.vtk", *vtk);
    vtk->SetFileTypeToBinary();
    keep("old_bytes.vtk", *vtk);
    vtk->SetFileVersion(vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_5_1);
    keep("bytes.vtk", *vtk);
    vtkNew<vtkXMLPolyDataWriter> vtp;
    keep("compressed.vtp", *vtp);
    vtp->EncodeAppendedDataOff();
    vtp->SetCompressorTypeToNone();
    keep("appended.vtp", *vtp);
    vtp->SetCompressorTypeToZLib();
    vtp->SetHeaderTypeToUInt64();
    vtp->SetByteOrderToBigEndian();
    keep("compressed_bytes.vtp", *vtp);
    vtp->SetCompressorTypeToNone();
    vtp->SetDataModeToAscii();
    keep("text.vtp", *vtp);
    vtkNew<vtkXMLPolyDataWriter> in_place;
    in_place->SetDataModeToBinary();
    in_place->SetHeaderTypeToUInt64();
    keep("compressed_in_place.vtp", *in_place);
    return files;
  }

  /// What is read of `bytes`; nothing where they are refused, which must be with one sentence.
  std::optional<Triangles> read(const std::string& name, const std::string& bytes)
  {
    const std::string path = folder_.path() / name;
    std::filesystem::remove(path);  // to write over a file waits for the disk
    std::ofstream(path, std::ios::binary) << bytes;
    try {
      return read_mesh_file(path);
    } catch (const InputError& problem) {
      const std::string sentence = problem.what();
      EXPECT_EQ(sentence.find("'file' must "), 0u) << sentence;
      EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
      EXPECT_NE(sentence.find(", found "), std::string::npos) << sentence;
      EXPECT_LT(sentence.size(), 300u) << sentence;
      return std::nullopt;
    }
  }

  TemporaryFolder folder_;
};

/// Most memory that this program has had [kB].
long peak_of_memory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

}  // namespace

TEST_F(DamagedMeshFile, CutOffAnywhereIsRefusedOrTheSameMesh)
{
  const SurfaceMesh tube = cylinder_mesh({0.05, 0.0, 0.1, 0.0157});  // 200 facets
  std::minstd_rand random(1);
  for (const auto& [name, bytes] : files_of(tube)) {
    const std::optional<Triangles> whole = read(name, bytes);
    ASSERT_TRUE(whole) << name;
    ASSERT_EQ(whole->size(), tube.facet.size()) << name;
    int refused = 0;
    for (int n = 0; n < 100; ++n) {
      const std::size_t size = n == 0 ? bytes.size() - 1 : random() % bytes.size();
      const std::optional<Triangles> cut = read(name, bytes.substr(0, size));
      EXPECT_EQ(cut.value_or(*whole), *whole) << name << " cut at " << size;
      refused += !cut;
    }
    EXPECT_GT(refused, 80) << name;
  }
}

// A coordinate that is another one cannot be told; anything else can be.
TEST_F(DamagedMeshFile, WithOneOtherByteIsRefusedOrAMesh)
{
  const SurfaceMesh tube = cylinder_mesh({0.05, 0.0, 0.05, 0.05});  // 12 facets: much is structure
  const long memory = peak_of_memory();
  std::minstd_rand random(2);
  for (const auto& [name, bytes] : files_of(tube)) {
    int refused = 0;
    for (int n = 0; n < 100; ++n) {
      std::string damaged = bytes;
      const std::size_t at = random() % bytes.size();
      const int byte = static_cast<int>(random() % 256);
      damaged[at] = static_cast<char>(byte);
      SCOPED_TRACE(name + " with " + std::to_string(byte) + " at " + std::to_string(at));
      const std::optional<Triangles> found = read(name, damaged);
      refused += !found;
      for (const auto& facet : found.value_or(Triangles()))
        for (const Vec3& corner : facet) EXPECT_TRUE(corner.allFinite());
    }
    EXPECT_LT(refused, 100) << name << ": is the whole file taken?";
  }
  EXPECT_LT(peak_of_memory() - memory, 500'000);
}

// What VTK's readers and filters take on trust: each of these ended the program, or filled
// gigabytes.
TEST_F(DamagedMeshFile, WhoseNumbersOfThingsAreNotSoIsRefused)
{
  const auto old_cells = [](const std::string& cells) {
    return "# vtk DataFile Version 3.0\nsleeve\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
           "0 0 0 1 0 0 0 2 0 1 2 3\n" +
           cells;
  };
  EXPECT_TRUE(read("a.vtk", old_cells("POLYGONS 2 8\n3 0 1 2\n3 1 3 2\n")));
  EXPECT_TRUE(read("a.vtk", old_cells("polygons 1 4\n3 0 1 2\n")));
  for (const char* cells :
       {"POLYGONS 2 8\n3 0 1 2\n30000 1 3 2\n", "POLYGONS 2 8\n3 0 1 2\n-3 1 3 2\n",
        "POLYGONS 1 8\n3 0 1 2\n3 1 3 2\n", "POLYGONS 3000 8\n3 0 1 2\n3 1 3 2\n",
        "polygons 2 8\n3 0 1 2\n30000 1 3 2\n", "TRIANGLE_STRIPS 1 5\n40000 0 1 2 3\n",
        "POLYGONS 2 8\n3 0 1 2\n3 1 3 4\n", "POLYGONS 2 8\n3 0 1 2\n3 1 3 -1\n",
        "POLYGONS 2 8\n3 0 1 2\n3 1 3 x\n"})
    EXPECT_FALSE(read("a.vtk", old_cells(cells))) << cells;

  const SurfaceMesh tube = cylinder_mesh({0.05, 0.0, 0.05, 0.05});
  const auto files = files_of(tube);
  for (const char* version : {"6.1", "3.1", ".51", "5-1", "515"}) {
    for (std::string name : {"text.vtk", "bytes.vtk"}) {
      std::string other = files.at(name);
      EXPECT_FALSE(read(name, other.replace(other.find("5.1"), 3, version))) << name << version;
    }
  }
  const std::string& text = files.at("text.vtp");
  for (const std::string tag :
       {"NumberOfComponents=\"3", "NumberOfPoints=\"12", "NumberOfPolys=\"12"})
    for (const char* number : {"", "\r", "-3", "3000000000", "x"}) {
      std::string other = text;
      const auto at = other.find(tag) + tag.find('"') + 1;
      EXPECT_FALSE(read("text.vtp", other.replace(at, other.find('"', at) - at, number)))
          << tag << " " << number;
    }
  // The head of an array that is appended: its number of bytes, or of blocks, bytes of a block, of
  // the last one, and of each in the file; the last array is of where the triangles begin.
  const std::string& plain = files.at("appended.vtp");
  std::string without_a_point = plain;
  without_a_point[plain.find('_', plain.find("<AppendedData")) + 1 + 316 + 8 + 5] = 1;
  EXPECT_FALSE(read("appended.vtp", without_a_point)) << "point 2^40";
  const std::string& big = files.at("compressed_bytes.vtp");
  const std::size_t head = big.find('_', big.find("<AppendedData")) + 1;
  for (std::size_t n = 0; n < 4; ++n)
    for (const std::size_t byte : {0, 3, 4}) {
      std::string other = big;
      other[head + 8 * n + byte] = '\x50';
      EXPECT_FALSE(read("compressed_bytes.vtp", other)) << n << " " << byte;
    }
}
