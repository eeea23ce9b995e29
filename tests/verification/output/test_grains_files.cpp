// SPDX-License-Identifier: GPL-2.0-only
// The files of `fix output/grains`, read back: motion known in closed form, contacts known by
// count.
#include "support/child_program.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

/// What one file holds; single precision.
class GrainsFile {
 public:
  explicit GrainsFile(const fs::path& file)
  {
    reader_->SetFileName(file.c_str());
    reader_->Update();
  }
  vtkPolyData* data() const { return reader_->GetOutput(); }
  bool has(const char* name) const { return data()->GetPointData()->HasArray(name); }
  std::vector<double> values(const char* name, int row) const
  {
    vtkDataArray* array = data()->GetPointData()->GetArray(name);
    if (!array) throw std::runtime_error(std::string("no array ") + name);
    std::vector<double> tuple(array->GetNumberOfComponents());
    array->GetTuple(row, tuple.data());
    return tuple;
  }

 private:
  vtkNew<vtkXMLPolyDataReader> reader_;
};

std::vector<std::string> files_of_collection(const fs::path& file)
{
  std::vector<std::string> files;
  const std::string text = read_text(file), before = "file=\"";
  for (auto at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
    const auto begin = at + before.size();
    files.push_back(text.substr(begin, text.find('"', begin) - begin));
  }
  return files;
}

void expect_vector(const std::vector<double>& found, const std::vector<double>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    EXPECT_NEAR(found[k], expected[k], 2e-7 * (1.0 + std::abs(expected[k])));
}

/// One grain that flies and spins freely from z = 0 to 0.2 m, past the border of two ranks.
std::string flight(const std::string& rest)
{
  return opening_deck("one_grain") +
         "group one id 1\n"
         "velocity one set 0.1 0 2 units box\n"
         "set group one omegax 1 omegay 20 omegaz -3\n" +
         rest;
}

/// Three of type 1 in a row: the middle one has two contacts, each end has one.
const char* const row_of_three =
    "create_atoms 1 single -0.0198 0 0.1 units box\n"
    "set group all diameter 0.02 density 2500\n";

std::string outcome_of(const std::string& deck, int ranks, const fs::path& folder)
{
  const Outcome outcome = run_deck(deck, ranks, folder);
  return outcome.exit_code == 0 ? "" : outcome.output;
}

}  // namespace

TEST(GrainsFile, HoldsTheFreeFlightOfAGrainOnTwoRanks)
{
  const TemporaryFolder folder;
  ASSERT_EQ(outcome_of(flight("fix out all output/grains every 500 folder grains\nrun 8000\n"), 2,
                       folder.path()),
            "");
  const std::vector<std::string> files = files_of_collection(folder.path() / "grains/grains.pvd");
  ASSERT_EQ(files.size(), 17u);  // step 0 too
  EXPECT_EQ(files.back(), "grains_000008000.vtp");

  const GrainsFile last(folder.path() / "grains" / files.back());
  ASSERT_EQ(last.data()->GetNumberOfPoints(), 1);
  EXPECT_EQ(last.data()->GetNumberOfVerts(), 1);
  const double time = 8000 * 1e-5;
  expect_vector(last.values("displacement", 0), {0.1 * time, 0.0, 2.0 * time});
  expect_vector(last.values("rotation", 0), {1.0 * time, 20.0 * time, -3.0 * time});
  expect_vector(last.values("velocity", 0), {0.1, 0.0, 2.0});
  expect_vector(last.values("radius", 0), {0.01});
  expect_vector(last.values("id", 0), {1.0});
  expect_vector(last.values("type", 0), {1.0});
  expect_vector(last.values("coordination_number", 0), {0.0});
  double x[3];
  last.data()->GetPoint(0, x);
  expect_vector({x[0], x[1], x[2]}, {0.1 * time, 0.0, 2.0 * time});
}

TEST(GrainsFile, CountsEveryContactAtBothItsGrains)
{
  for (const int ranks : {1, 2, 4}) {
    const TemporaryFolder folder;
    ASSERT_EQ(outcome_of(opening_deck("two_grains") + row_of_three +
                             "fix out all output/grains every 5 folder grains\n"
                             "run 5\n",
                         ranks, folder.path()),
              "");
    for (const char* file : {"grains/grains_000000000.vtp", "grains/grains_000000005.vtp"}) {
      const GrainsFile grains(folder.path() / file);
      ASSERT_EQ(grains.data()->GetNumberOfPoints(), 3);
      expect_vector(grains.values("coordination_number", 0), {2.0});
      expect_vector(grains.values("coordination_number", 1), {1.0});
      expect_vector(grains.values("coordination_number", 2), {1.0});
    }
  }
}

// Two grains one above the other, the border of two ranks between them.
TEST(GrainsFile, CountsAContactAcrossABorderOnce)
{
  const TemporaryFolder folder;
  ASSERT_EQ(outcome_of(opening_deck("empty_cylinder") +
                           "create_atoms 1 single 0 0 0.0901 units box\n"
                           "create_atoms 1 single 0 0 0.1099 units box\n"
                           "set group all diameter 0.02 density 2500\n"
                           "fix move all nve/sphere\n"
                           "fix out all output/grains every 5 folder grains\n"
                           "run 5\n",
                       2, folder.path()),
            "");
  const GrainsFile grains(folder.path() / "grains/grains_000000005.vtp");
  ASSERT_EQ(grains.data()->GetNumberOfPoints(), 2);
  expect_vector(grains.values("coordination_number", 0), {1.0});
  expect_vector(grains.values("coordination_number", 1), {1.0});
}

// A further run computes the forces of the step between the runs again.
TEST(GrainsFile, CountsAContactOnceWhereTwoRunsMeet)
{
  const TemporaryFolder folder;
  ASSERT_EQ(
      outcome_of(opening_deck("two_grains") + "fix out all output/grains every 5 folder grains\n"
                                              "run 3\nrun 0\nfix_modify out write now\n",
                 1, folder.path()),
      "");
  const GrainsFile grains(folder.path() / "grains/grains_000000003.vtp");
  expect_vector(grains.values("coordination_number", 0), {1.0});
}

TEST(GrainsFile, CountsAWallAsAContact)
{
  const TemporaryFolder folder;
  ASSERT_EQ(
      outcome_of(opening_deck("one_grain") +
                     "fix floor all wall/gran model linear tangential history primitive type 2 "
                     "zplane -0.0099\n"
                     "fix out all output/grains every 5 folder grains\nrun 1\n"
                     "fix_modify out write now\n",
                 1, folder.path()),
      "");
  expect_vector(
      GrainsFile(folder.path() / "grains/grains_000000001.vtp").values("coordination_number", 0),
      {1.0});
}

TEST(GrainsFile, StartsMotionAnewOnReset)
{
  const TemporaryFolder folder;
  ASSERT_EQ(outcome_of(flight("fix out all output/grains every 500 folder grains\nrun 1000\n"
                              "fix_modify out reset\nrun 500\n"),
                       1, folder.path()),
            "");
  const GrainsFile last(folder.path() / "grains/grains_000001500.vtp");
  expect_vector(last.values("displacement", 0), {0.0005, 0.0, 0.01});
  expect_vector(last.values("rotation", 0), {0.005, 0.1, -0.015});
}

TEST(GrainsFile, LeavesOutTheRotationThatIsSwitchedOff)
{
  const TemporaryFolder folder;
  ASSERT_EQ(outcome_of(flight("fix out all output/grains every 10 folder out name sand "
                              "rotation no compress no\nrun 10\n"),
                       1, folder.path()),
            "");
  const GrainsFile last(folder.path() / "out/sand_000000010.vtp");
  EXPECT_FALSE(last.has("rotation"));
  expect_vector(last.values("displacement", 0), {1e-5, 0.0, 2e-4});
}

TEST(GrainsFile, GoesOnAfterARestartAsIfTheRunHadNotStopped)
{
  const std::string output = "fix out all output/grains every 500 folder grains\n";
  const TemporaryFolder whole, parts;
  ASSERT_EQ(outcome_of(flight(output + "run 700\nrun 300\n"), 1, whole.path()), "");
  ASSERT_EQ(outcome_of(flight(output + "run 700\nwrite_restart stop\n"), 1, parts.path()), "");
  const std::string opening = opening_deck("one_grain");
  const std::string materials = opening.substr(
      opening.find("neighbor "), opening.find("create_atoms") - opening.find("neighbor "));
  ASSERT_EQ(outcome_of("atom_style granular\natom_modify map array\nnewton off\n"
                       "communicate single vel yes\nread_restart stop\n" +
                           materials + "fix move all nve/sphere\n" + output + "run 300\n",
                       1, parts.path()),
            "");
  EXPECT_EQ(read_text(parts.path() / "grains/grains_000001000.vtp"),
            read_text(whole.path() / "grains/grains_000001000.vtp"));
  const std::string series = read_text(parts.path() / "grains/grains.pvd");
  for (const char* entry : {"\"0\" part=\"0\" file=\"grains_000000000.vtp\"",
                            "\"0.005\" part=\"0\" file=\"grains_000000500.vtp\"",
                            "\"0.01\" part=\"0\" file=\"grains_000001000.vtp\""})
    EXPECT_NE(series.find(entry), std::string::npos) << entry << " in\n" << series;
  EXPECT_EQ(series.find("grains_000000700.vtp"), std::string::npos) << "no file where it stopped";
}

TEST(GrainsFile, LeavesNoUnfinishedFileBehind)
{
  const TemporaryFolder folder;
  ASSERT_EQ(outcome_of(flight("fix out all output/grains every 10 folder grains\nrun 10\n"), 1,
                       folder.path()),
            "");
  for (const auto& entry : fs::directory_iterator(folder.path() / "grains"))
    EXPECT_NE(entry.path().extension(), ".part");
}

TEST(GrainsFile, IsRefusedBeforeTheFirstStepWhereItCannotBeWritten)
{
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "taken") << "a file, not a folder";
  const Outcome outcome = run_deck(
      flight("fix out all output/grains every 10 folder taken\nrun 10\n"), 2, folder.path());
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.says("'folder' must be a folder that can be written, found 'taken'"))
      << outcome.output;
}
