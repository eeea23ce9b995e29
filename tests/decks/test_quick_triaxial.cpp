// SPDX-License-Identifier: GPL-2.0-only
// The plain triaxial test at the resolution `quick`, on half its height and to 8 % strain, where q
// comes close to its peak: what a run of the study must show. Some ten seconds of work.
#include "support/child_program.h"
#include "support/csv_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace encased_column::testing;

namespace {

/// One run for all tests.
class QuickTriaxialTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite()
  {
    folder_ = new TemporaryFolder;
    const std::filesystem::path inputs = std::filesystem::path(ENCASE_SOURCE) / "input_scripts";
    const Outcome outcome =
        run_deck(read_text(inputs / "triaxial_plain/triaxial_plain.lmp"), 1, folder_->path(),
                 {"-var", "common", inputs / "common", "-var", "parameters", "study", "-var",
                  "resolution", "quick", "-var", "height", "0.1", "-var", "strain_end", "0.08"});
    failure_ = outcome.exit_code == 0 ? "" : outcome.output;
  }
  static void TearDownTestSuite() { delete folder_; }
  void SetUp() override { ASSERT_EQ(failure_, ""); }

  static std::vector<double> column(const std::string& name)
  {
    return CsvTable(folder_->path() / "history.csv").column(name);
  }
  static std::string text(const std::string& file) { return read_text(folder_->path() / file); }

 private:
  inline static TemporaryFolder* folder_ = nullptr;
  inline static std::string failure_;
};

}  // namespace

TEST_F(QuickTriaxialTest, HoldsTheConfiningStressWithinOnePercent)
{
  for (const double stress : column("confining_stress [Pa]")) EXPECT_NEAR(stress, 50e3, 500.0);
}

TEST_F(QuickTriaxialTest, CarriesTheSameStressOnBothPlatensOverOnePercentOfStrain)
{
  const auto strain = column("axial_strain [-]"), top = column("stress_top [Pa]"),
             bottom = column("stress_bottom [Pa]");
  for (const double begin : {0.0, 0.0099}) {
    double of_top = 0.0, of_bottom = 0.0;
    for (std::size_t n = 0; n < strain.size(); ++n) {
      if (strain[n] < begin || strain[n] > begin + 0.01) continue;
      of_top += top[n];
      of_bottom += bottom[n];
    }
    EXPECT_NEAR(of_top / of_bottom, 1.0, 0.03) << "from " << begin;
  }
}

// The lower platen carries the weight of the grains too.
TEST_F(QuickTriaxialTest, StandsOnTheLowerPlatenWithItsWeight)
{
  const double porosity = column("porosity [-]").front(), height = column("height [m]").front();
  const double weight = 1738.0 * (1.0 - porosity) * height * 9.8;
  const double difference =
      column("stress_bottom [Pa]").front() - column("stress_top [Pa]").front();
  EXPECT_NEAR(difference, weight, 0.02 * weight);
}

TEST_F(QuickTriaxialTest, StartsInEquilibriumAtTheRatioOfTheStudy)
{
  EXPECT_LE(column("unbalanced_average [-]").front(), 1e-5);
}

TEST_F(QuickTriaxialTest, StaysQuasiStatic)
{
  for (const double number : column("inertial_number [-]")) EXPECT_LT(number, 1e-3);
}

// 2 % are asked of it; the step makes an error near 1e-6, and a work or loss left out one above
// 1e-2.
TEST_F(QuickTriaxialTest, ClosesItsEnergyBalance)
{
  for (const double error : column("energy_error [-]")) EXPECT_LT(error, 1e-4);
  EXPECT_GT(column("loss_friction [J]").back(), 0.0);
}

// The history looks at every row and stops the run otherwise.
TEST_F(QuickTriaxialTest, KeepsEveryGrainInsideTheWalls)
{
  EXPECT_NE(text("progress.txt").find("1.00 done"), std::string::npos);
  EXPECT_GE(column("axial_strain [-]").back(), 0.077);  // a row every 0.23 %
}

// Rankine: q = (Kp - 1) sigma3, Kp = (1 + sin phi) / (1 - sin phi); the range holds loose sand and
// the densest gravel.
TEST_F(QuickTriaxialTest, BearsWhatGrainsWithAFrictionAngleOfTwentyToFortyFiveDegreesDo)
{
  const auto rankine = [](double degrees) {
    const double sine = std::sin(degrees * std::acos(-1.0) / 180.0);
    return 50e3 * ((1.0 + sine) / (1.0 - sine) - 1.0);
  };
  const auto q = column("deviatoric_stress_bottom [Pa]");
  const double largest = *std::max_element(q.begin(), q.end());
  EXPECT_GT(largest, rankine(20.0));
  EXPECT_LT(largest, rankine(45.0));
}

// Compression is positive.
TEST_F(QuickTriaxialTest, ContractsAtFirstAndThenDilates)
{
  const auto strain = column("volumetric_strain [-]");
  const auto largest = std::max_element(strain.begin(), strain.end());
  EXPECT_GT(*largest, 0.0);
  EXPECT_LT(strain.back(), 0.9 * *largest);
}
