// SPDX-License-Identifier: GPL-2.0-only
// The deck of the plain triaxial test, whole, with about a hundred grains and 2 % strain: a second
// of work.
#include "support/csv_table.h"
#include "support/small_triaxial.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

/// One run for all tests.
class SmallTriaxialTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite()
  {
    folder_ = new TemporaryFolder;
    outcome_ = new Outcome(run_small_triaxial(folder_->path(), 1));
  }
  static void TearDownTestSuite()
  {
    delete outcome_;
    delete folder_;
  }
  void SetUp() override { ASSERT_EQ(outcome_->exit_code, 0) << outcome_->output; }

  static fs::path file(const std::string& name) { return folder_->path() / name; }
  static CsvTable history() { return CsvTable(file("history.csv")); }

 private:
  inline static TemporaryFolder* folder_ = nullptr;
  inline static Outcome* outcome_ = nullptr;
};

}  // namespace

TEST_F(SmallTriaxialTest, LeavesWhatPicturesAndTablesAreMadeFrom)
{
  EXPECT_GT(fs::file_size(file("gradation.csv")), 0u);
  EXPECT_GT(fs::file_size(file("grains/grains.pvd")), 0u);
  EXPECT_TRUE(read_text(file("progress.txt")).find("1.00 done") != std::string::npos);
}

TEST_F(SmallTriaxialTest, GoesFromNoStrainToTheStrainAskedFor)
{
  const std::vector<double> strain = history().column("axial_strain [-]");
  EXPECT_EQ(strain.front(), 0.0);
  EXPECT_NEAR(strain.back(), 0.02, 0.002);  // a row every 200 steps of 1e-5
}

TEST_F(SmallTriaxialTest, HoldsTheConfiningStressWithinOnePercent)
{
  for (const double stress : history().column("confining_stress [Pa]"))
    EXPECT_NEAR(stress, 50e3, 500.0);
}

TEST_F(SmallTriaxialTest, StartsInEquilibriumAndStaysQuasiStatic)
{
  EXPECT_LT(history().column("unbalanced_average [-]").front(), 1e-4);
  for (const double number : history().column("inertial_number [-]")) EXPECT_LT(number, 1e-3);
}

// Sum of the work put in against stored, kinetic and lost energy, from the columns themselves.
TEST_F(SmallTriaxialTest, ClosesItsEnergyBalanceWithinTwoPercent)
{
  const CsvTable table = history();
  const auto change = [&](const std::string& name) {
    const std::vector<double> column = table.column(name + " [J]");
    return column.back() - column.front();
  };
  const double platens = change("work_platens");
  const double work = platens + change("work_side") + change("work_gravity");
  double found = change("energy_elastic") + change("energy_kinetic");
  for (const char* loss : {"loss_friction", "loss_rolling", "loss_dashpots", "loss_damping"})
    found += change(loss);
  EXPECT_GT(platens, 0.0);
  EXPECT_NEAR(found, work, 0.02 * std::abs(platens));
}
