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

/// Upright bars of 20 N on the left, 10 N on the right and 4.9 N between them.
void write_bars(const fs::path& run)
{
  std::vector<ContactRecord> contacts;
  for (const auto& [x, force] : {std::pair{-0.03, 20.0}, {0.0, 4.9}, {0.03, 10.0}}) {
    ContactRecord contact{};
    contact.from = {x, 0.0, 0.05};
    contact.to = {x, 0.0, 0.15};
    contact.force = force;
    contacts.push_back(contact);
  }
  ASSERT_TRUE(write_contacts(make_series(run, "contacts"), contacts));
}

/// Two runs, the older of which knows neither contacts nor strains; drawn once for all tests.
class PicturesTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite()
  {
    folder_ = new TemporaryFolder;
    const fs::path series = folder_->path();
    write_case(series / "plain", "plain");
    write_column(series / "plain", true);
    write_bars(series / "plain");
    write_case(series / "encased", "encased");
    write_column(series / "encased", false);
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
