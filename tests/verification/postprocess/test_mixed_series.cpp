// SPDX-License-Identifier: GPL-2.0-only
// Runs that were not made with what the rows of series.csv say.
#include "closed_form_case.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

/// Two plain tests, the second with twice the stresses, and what the program makes of them.
class MixedSeries : public ::testing::Test {
 protected:
  std::string tables(const std::string& first, const std::string& second)
  {
    const fs::path one = series_.path() / "one", two = series_.path() / "two";
    write_case(one, "plain");
    describe_case(one, "plain", "\"sigma3\": 50000, " + first);
    write_case(two, "plain", true, 2.0);
    describe_case(two, "plain", "\"sigma3\": 100000, " + second);
    return run_program({ENCASE_COMMAND, "report", "--no-pictures", series_.path()}, series_.path())
        .output;
  }
  static bool has(const std::string& text, const std::string& part)
  {
    return text.find(part) != std::string::npos;
  }

 private:
  TemporaryFolder series_;
};

}  // namespace

TEST_F(MixedSeries, NamesAllResolutionsAndWhatElseTheLineMixes)
{
  const std::string text = tables(R"("resolution": "quick", "mu": 0.8, "frames": 20)",
                                  R"("resolution": "paper", "mu": 0.5, "frames": 5)");
  EXPECT_TRUE(has(text, "Plain triaxial tests, resolutions quick, paper, q from")) << text;
  EXPECT_TRUE(has(text,
                  "The line of the plain tests, and so phi and c, mixes runs that differ in "
                  "more than sigma3: resolution (quick, paper), mu (0.8, 0.5)."))
      << text;
}

TEST_F(MixedSeries, SaysNothingWhereOnlyTheConfiningStressDiffers)
{
  const std::string text = tables(R"("resolution": "quick", "mu": 0.8, "frames": 20)",
                                  R"("resolution": "quick", "mu": 0.8, "frames": 5)");
  EXPECT_TRUE(has(text, "Plain triaxial tests, resolution quick, q from")) << text;
  EXPECT_TRUE(has(text, "apparent friction angle")) << text;
  EXPECT_FALSE(has(text, "mixes")) << text;
}
