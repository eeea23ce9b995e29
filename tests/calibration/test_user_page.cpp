// SPDX-License-Identifier: GPL-2.0-only
// The page calibration/README.md lists the keys and quantities that the reader knows, in its words.
#include "config/calibration_config.h"
#include "config/quantities.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace encased_column;

TEST(UserPage, ListsEveryKeyAndQuantity)
{
  const std::string page = encased_column::testing::read_text(std::filesystem::path(ENCASE_SOURCE) /
                                                              "calibration/README.md");
  const ConfigKeys& keys = config_keys();
  for (const auto& part :
       {keys.top, keys.runs, keys.parameter, keys.target, keys.design, keys.search})
    for (const ConfigKey& key : part) {
      const std::string row = "| `" + key.name + "` | " + key.meaning + " |\n";
      EXPECT_NE(page.find(row), std::string::npos) << row;
    }
  for (const Quantity& one : quantities()) {
    const std::string row = "| `" + one.name + "` | " + one.unit + " | " + one.meaning + " |\n";
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
}

TEST(UserPage, HasExamplesThatAreRead)
{
  for (const char* name : {"plain_triaxial", "sleeve", "try_out"}) {
    const CalibrationConfig found = read_calibration(std::filesystem::path(ENCASE_SOURCE) /
                                                     "calibration" / (std::string(name) + ".yaml"));
    EXPECT_GE(found.space.size(), 3) << name;
  }
}
