// SPDX-License-Identifier: GPL-2.0-only
// The deck of the columns, whole, at its own height and to its own end, but of few coarse grains in
// a narrow sleeve, compressed fast: some seconds of work. What the deck sets must reach the run.
#include "support/csv_table.h"
#include "support/small_triaxial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const fs::path inputs = fs::path(ENCASE_SOURCE) / "input_scripts";

/// One run for all tests.
class ShortColumnTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite()
  {
    folder_ = new TemporaryFolder;
    prepare_small_resolution(folder_->path());
    // In place of S1: the deck asks for this file by its name.
    std::ofstream(file("common/gradation_column_S1.csv"))
        << "diameter_low [m],diameter_high [m],mass_percent [%]\n0.013,0.016,30\n0.016,0.020,70\n";
    std::vector<std::string> arguments;
    for (const auto& [name, value] : {std::pair("common", "common"),
                                      {"resolution", "small"},
                                      {"parameters", "study"},
                                      {"radius", "0.04"},
                                      {"porosity", "0.45"},
                                      {"limit", "1e-3"},
                                      {"facet", "20e-3"},
                                      {"rate", "1e-5"}})
      arguments.insert(arguments.end(), {"-var", name, value});
    const Outcome outcome =
        run_deck(read_text(inputs / "column/column.lmp"), 1, folder_->path(), arguments);
    failure_ = outcome.exit_code == 0 ? "" : outcome.output;
  }
  static void TearDownTestSuite() { delete folder_; }
  void SetUp() override { ASSERT_EQ(failure_, ""); }

  static fs::path file(const std::string& name) { return folder_->path() / name; }
  static std::vector<double> history(const std::string& name)
  {
    return CsvTable(file("history.csv")).column(name);
  }

 private:
  inline static TemporaryFolder* folder_ = nullptr;
  inline static std::string failure_;
};

}  // namespace

// Section 3 of the study: 500 mm high, 50 kPa around, compressed by 30 mm (Figure 11).
TEST_F(ShortColumnTest, IsCompressedByThirtyMillimetresAtFiftyKilopascals)
{
  const std::vector<double> height = history("height [m]");
  EXPECT_NEAR(height.front(), 0.500, 1e-9);
  EXPECT_NEAR(height.front() - height.back(), 0.030, 200 * 1e-5);  // a row every 200 steps
  for (const double stress : history("confining_stress [Pa]")) EXPECT_NEAR(stress, 50e3, 500.0);
  EXPECT_NE(read_text(file("progress.txt")).find("1.00 done"), std::string::npos);
}

// Section 3.1: nine spheres of 80 mm one above the other, the outer ones on the platens.
TEST_F(ShortColumnTest, IsMeasuredByNineSpheresAlongItsHeight)
{
  const CsvTable spheres(file("spheres.csv"));
  const std::vector<double> number = spheres.column("sphere [-]"), z = spheres.column("z [m]"),
                            radius = spheres.column("radius [m]");
  ASSERT_EQ(*std::max_element(number.begin(), number.end()), 9.0);
  ASSERT_EQ(spheres.rows() % 9, 0u);
  for (std::size_t s = 0; s < 9; ++s) {
    EXPECT_EQ(number[s], static_cast<double>(s + 1));
    EXPECT_EQ(radius[s], 0.040);
    EXPECT_NEAR(z[s], 0.040 + static_cast<double>(s) * (0.500 - 0.080) / 8.0, 1e-9);
  }
}

TEST_F(ShortColumnTest, IsOfTheGradationInTheFileThatItsDeckNames)
{
  const std::string table = read_text(file("gradation.csv"));
  for (const char* row : {"\n0.013,0.016,30,", "\n0.016,0.02,70,"})
    EXPECT_NE(table.find(row), std::string::npos) << row << " not in\n" << table;
}
