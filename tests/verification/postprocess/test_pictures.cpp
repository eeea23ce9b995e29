// SPDX-License-Identifier: GPL-2.0-only
// 3-D pictures of grains and contacts that are known: a column of two halves, and three bars in it.
#include "closed_form_case.h"
#include "files/pvd_collection.h"
#include "files/vtk_files.h"
#include "picture_pixels.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

/// A series of one file, as a run leaves it.
fs::path make_series(const fs::path& run, const std::string& name)
{
  fs::create_directories(run / name);
  std::ofstream(run / name / (name + ".pvd")) << pvd_text({{1.0, name + ".vtp"}});
  return run / name / (name + ".vtp");
}

/// Grains of 10 mm side by side in a box of 100 mm x 100 mm x 200 mm. Behind the plane y = 0 the
/// upper half is strained by 20 %, the lower by 1 %; before it all are strained by 500 %.
void write_column(const fs::path& run, bool strain)
{
  std::vector<GrainRecord> grains;
  for (int i = 0; i < 10 * 10 * 20; ++i) {
    GrainRecord grain{};
    grain.id = i + 1;
    grain.radius = 5e-3;
    grain.position = {0.01 * (i % 10) - 0.045, 0.01 * (i / 10 % 10) - 0.045,
                      0.01 * (i / 100) + 0.005};
    const double behind = grain.position[2] > 0.1 ? 0.20 : 0.01;
    grain.deviatoric_strain = grain.position[1] > 0.0 ? behind : 5.0;
    grains.push_back(grain);
  }
  GrainFileOptions options;
  options.strain = strain;
  ASSERT_TRUE(write_grains(make_series(run, "grains"), grains, options));
}

/// Upright bars of these forces [N] from left to right.
void write_bars_into(const fs::path& file, const std::vector<double>& forces)
{
  std::vector<ContactRecord> contacts;
  for (const double force : forces) {
    const double x =
        0.06 * static_cast<double>(contacts.size()) / static_cast<double>(forces.size() - 1) - 0.03;
    ContactRecord contact{};
    contact.from = {x, 0.0, 0.05};
    contact.to = {x, 0.0, 0.15};
    contact.force = force;
    contacts.push_back(contact);
  }
  ASSERT_TRUE(write_contacts(file, contacts));
}

void write_bars(const fs::path& run, const std::vector<double>& forces)
{
  write_bars_into(make_series(run, "contacts"), forces);
}

/// An encased run with these bars at the first and at the last step of its history, 22 % apart.
void write_loaded(const fs::path& run, const std::vector<double>& before,
                  const std::vector<double>& after)
{
  write_case(run, "encased", true, 5.0);
  describe_case(run, "encased", R"("sigma3": 250000)");
  write_column(run, false);
  std::ofstream(run / "grains/grains.pvd") << pvd_text({{0.0, "grains.vtp"}, {22e3, "grains.vtp"}});
  write_bars(run, before);
  write_bars_into(run / "contacts/after.vtp", after);
  std::ofstream(run / "contacts/contacts.pvd")
      << pvd_text({{0.0, "contacts.vtp"}, {22e3, "after.vtp"}});
}

/// An encased run at `stress` [kPa] whose files have its contacts of `chains` [N] and more.
void write_chains(const fs::path& run, int stress, const std::string& chains)
{
  write_case(run, "encased", true, stress / 50.0);
  describe_case(run, "encased",
                R"("sigma3": )" + std::to_string(1000 * stress) + R"(, "chains": )" + chains);
  write_column(run, false);
  write_bars(run, {80.0, 50.0, 30.0, 60.0});
}

/// Runs, the oldest of which knows neither contacts nor strains; drawn once for all tests.
class PicturesTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite()
  {
    folder_ = new TemporaryFolder;
    const fs::path series = folder_->path();
    write_case(series / "plain", "plain");
    write_column(series / "plain", true);
    write_bars(series / "plain", {20.0, 4.9, 10.0});
    write_case(series / "encased", "encased");
    write_column(series / "encased", false);
    write_chains(series / "all_chains", 100, "5");
    write_chains(series / "some_chains", 150, "30");
    write_chains(series / "few_chains", 200, "70");
    write_loaded(series / "loaded", {20.0, 30.0}, {60.0, 4.9, 40.0});
    outcome_ = run_program({ENCASE_COMMAND, "report", "--draft", series}, series);
  }
  static void TearDownTestSuite() { delete folder_; }
  void SetUp() override { ASSERT_EQ(outcome_.exit_code, 0) << outcome_.output; }

  static fs::path file(const std::string& name) { return folder_->path() / "figures" / name; }
  inline static Outcome outcome_;

 private:
  inline static TemporaryFolder* folder_ = nullptr;
};

}  // namespace

TEST_F(PicturesTest, StandOnWhite)
{
  for (const char* name :
       {"specimen_plain.png", "shear_band_plain.png", "force_chains_plain.png"}) {
    ASSERT_TRUE(fs::exists(file(name))) << name;
    const PicturePixels picture(file(name));
    ASSERT_TRUE(picture.has_the_size_of_all()) << name;
    int marked = 0;
    for (int y = 0; y < 1500; ++y) marked += !picture.is_white(0, y) + !picture.is_white(1199, y);
    for (int x = 0; x < 1200; ++x) marked += !picture.is_white(x, 0) + !picture.is_white(x, 1499);
    EXPECT_EQ(marked, 0) << name << ": cut off at an edge";
    EXPECT_FALSE(picture.is_white(400, 750)) << name;
  }
}

// Half the force, half as thick; what bears less than 5 N is left out.
TEST_F(PicturesTest, OfForceChainsHaveBarsAsThickAsTheirForce)
{
  const PicturePixels picture(file("force_chains_plain.png"));
  for (int y = 650; y < 850; y += 50) {
    const std::vector<int> widths = picture.colored_widths(y);
    ASSERT_EQ(widths.size(), 2u) << "row " << y;
    EXPECT_GT(widths[0], 10) << "row " << y;
    EXPECT_NEAR(widths[1], 0.5 * widths[0], 1.5) << "row " << y;
  }
}

// Figure 13a: of an encased run both before and after loading, at one scale.
TEST_F(PicturesTest, OfForceChainsShowTheStartOfShearBesideItsEnd)
{
  const PicturePixels picture(file("force_chains_loaded.png"));
  ASSERT_EQ(picture.width(), 1500);
  constexpr int view = 635;  // px wide: half of what the color bar leaves
  const int y = picture.height() * 2 / 5;
  const std::vector<int> before = picture.colored_widths(y, 1, view),
                         after = picture.colored_widths(y, view, 2 * view);
  ASSERT_EQ(before.size(), 2u);
  ASSERT_EQ(after.size(), 2u) << "4.9 N are left out";
  EXPECT_NEAR(before[0], after[0] / 3.0, 1.5);
  EXPECT_NEAR(before[1], after[0] / 2.0, 1.5);
  EXPECT_NEAR(after[1], after[0] / 1.5, 1.5);
}

// Figure 13b: 80, 50, 30 and 60 N stand in the views of 20, 40 and 60 N as far as they bear that,
// and as thick in each.
TEST_F(PicturesTest, OfForceLevelsShowWhatBearsEachSideBySide)
{
  const PicturePixels picture(file("force_levels_all_chains.png"));
  ASSERT_EQ(picture.width(), 1500);
  constexpr int view = 423;  // px wide: a third of what the color bar leaves
  const int y = picture.height() * 2 / 5;
  const std::vector<int> all = picture.colored_widths(y, 1, view);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(picture.colored_widths(y, view, 2 * view), (std::vector<int>{all[0], all[1], all[3]}));
  EXPECT_EQ(picture.colored_widths(y, 2 * view, 3 * view), (std::vector<int>{all[0], all[3]}));
}

// What a run dropped is not shown as if there were none.
TEST_F(PicturesTest, OfForceLevelsLeaveOutLevelsBelowWhatTheRunWrote)
{
  const PicturePixels picture(file("force_levels_some_chains.png"));
  constexpr int view = 635;  // half
  const int y = picture.height() * 2 / 5;
  EXPECT_EQ(picture.colored_widths(y, 1, view).size(), 3u) << "40 N";
  EXPECT_EQ(picture.colored_widths(y, view, 2 * view).size(), 2u) << "60 N";
  EXPECT_FALSE(fs::exists(file("force_levels_few_chains.png")));
  EXPECT_TRUE(outcome_.says("no picture of force chains of 20, 40 and 60 N of 'few_chains'"));
}

// The grains before the cut, were they drawn, would make all others violet.
TEST_F(PicturesTest, OfShearBandsShowTheStrainBehindTheCut)
{
  const PicturePixels picture(file("shear_band_plain.png"));
  EXPECT_TRUE(picture.is_yellow(800, PicturePixels::top));
  EXPECT_TRUE(picture.is_violet(100, 600));
}

TEST_F(PicturesTest, AreLeftOutWithANoteWhereARunDidNotWriteWhatTheyShow)
{
  EXPECT_TRUE(fs::exists(file("specimen_encased.png")));
  EXPECT_FALSE(fs::exists(file("shear_band_encased.png")));
  EXPECT_FALSE(fs::exists(file("force_chains_encased.png")));
  EXPECT_TRUE(outcome_.says("no picture of shear bands of 'encased'"));
  EXPECT_TRUE(outcome_.says("no picture of force chains of 'encased'"));
  EXPECT_FALSE(outcome_.says("of 'plain'"));
}
