// SPDX-License-Identifier: GPL-2.0-only
// all.pvd of the decks: every file it lists, read with the library that ParaView reads it with.
#include "support/small_triaxial.h"
#include "verification/output/vtp_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

/// What must be in a file of each part.
void expect_part(const std::string& name, const fs::path& path, int grains)
{
  SCOPED_TRACE(path.string());
  const VtpFile file(path);
  const auto points = static_cast<std::size_t>(file.data()->GetNumberOfPoints());
  const auto cells = static_cast<std::size_t>(file.data()->GetNumberOfCells());
  if (name == "grains") {
    EXPECT_EQ(points, static_cast<std::size_t>(grains));
    for (const char* array : {"radius", "deviatoric_strain [-]", "coordination_number"})
      EXPECT_EQ(file.of_points(array).size(), points);
  } else if (name == "contacts") {
    EXPECT_GT(cells, 20u);
    EXPECT_EQ(points, 2 * cells);
    for (const double force : file.of_points("force [N]")) EXPECT_GE(force, 5.0);
    for (const char* array : {"normal_force [N]", "shear_force [N]", "kind [-]", "sliding [-]"})
      EXPECT_EQ(file.of_cells(array).size(), cells);
  } else {
    ASSERT_EQ(name, "sleeve");
    EXPECT_GT(cells, 500u);
    EXPECT_EQ(file.of_cells("hoop_tension [N/m]").size(), cells);
  }
}

/// Runs a deck with about a hundred grains and looks at its collection: `parts` at every time.
void expect_collection(const std::string& deck, const std::vector<std::string>& parts)
{
  const TemporaryFolder folder;
  std::vector<std::string> arguments = prepare_small_triaxial(folder.path());
  arguments.insert(arguments.end(), {"-var", "frames", "4"});
  const Outcome outcome =
      run_deck(read_text(fs::path(ENCASE_SOURCE) / "input_scripts" / deck / (deck + ".lmp")), 1,
               folder.path(), arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;

  const fs::path collection = folder.path() / "all.pvd";
  const std::vector<std::string> files = listed_in(collection),
                                 names = listed_in(collection, "name"),
                                 times = listed_in(collection, "timestep"),
                                 numbers = listed_in(collection, "part");
  ASSERT_GE(files.size(), 3 * parts.size());
  ASSERT_EQ(files.size() % parts.size(), 0u);
  const int grains = static_cast<int>(
      VtpFile(folder.path() / "grains" / listed_in(folder.path() / "grains/grains.pvd").front())
          .data()
          ->GetNumberOfPoints());
  EXPECT_GT(grains, 50);
  for (std::size_t n = 0; n < files.size(); ++n) {
    const std::size_t part = n % parts.size();
    EXPECT_EQ(names[n], parts[part]);
    EXPECT_EQ(numbers[n], std::to_string(part));
    EXPECT_EQ(times[n], times[n - part]) << "all parts at every time";
    expect_part(names[n], folder.path() / files[n], grains);
  }
  for (const std::string& part : parts)
    EXPECT_EQ(listed_in(folder.path() / part / (part + ".pvd")).size(),
              files.size() / parts.size());
}

}  // namespace

TEST(Collection, OfAPlainTestOpensGrainsAndChains)
{
  expect_collection("triaxial_plain", {"grains", "contacts"});
}

TEST(Collection, OfAnEncasedTestOpensGrainsSleeveAndChains)
{
  expect_collection("triaxial_encased", {"grains", "sleeve", "contacts"});
}

// A measuring sphere may be a part; the collection may stand in another folder than its parts.
TEST(Collection, FindsItsPartsFromWhereItStands)
{
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "views");
  const Outcome outcome =
      run_deck(opening_deck("two_grains") +
                   "fix balls all measure/sphere sphere 0 0 0.1 0.05 every 5 folder spheres\n"
                   "fix pictures all output/grains every 5 folder views/grains\n"
                   "fix together all output/collection part balls part pictures file "
                   "views/both.pvd\nrun 5\nrun 5\n",
               2, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const std::vector<std::string> files = listed_in(folder.path() / "views/both.pvd");
  ASSERT_EQ(files.size(), 6u);
  EXPECT_EQ(files[4], "../spheres/spheres_000000010.vtp");
  EXPECT_EQ(files[5], "grains/grains_000000010.vtp");
  for (const std::string& file : files)
    EXPECT_GT(VtpFile(folder.path() / "views" / file).data()->GetNumberOfPoints(), 0);
}
