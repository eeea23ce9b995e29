// SPDX-License-Identifier: GPL-2.0-only
// A user of LIGGGHTS takes a deck of their own over, one change at a time: the steps are those of
// the tutorial, which say what each deck must print.
#include "support/child_program.h"
#include "support/tutorial.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace encased_column::testing;
namespace fs = std::filesystem;

// Columns of four grains on springs of 1e5 N/m, in closed form: what the pages claims of all decks.
TEST(ExistingDeck, IsTakenOverOneChangeAtATime)
{
  const TemporaryFolder home;
  const fs::path page = fs::path(ENCASE_SOURCE) / "input_scripts/tutorials/existing_deck.md";
  const auto steps = read_steps(page);
  ASSERT_EQ(follow(steps, home.path(), clone_in(home.path())), "");

  const double weight = 9.81 * 2500.0 * 4.0 / 3.0 * M_PI * 1e-6;  // of a grain of 10 mm radius
  const double all = std::round(1e3 * 64 * weight) / 1e3;
  const double top = 70.0 - 1e3 * (4 + 3 + 2 + 1) * weight / 1e5;
  char line[200];
  std::snprintf(line, sizeof line, "The floor bears %g N of %g N, the highest center is at %.4f mm",
                all, all, top);
  int decks = 0;
  for (const TutorialStep& step : steps)
    if (step.kind == "output" && step.text.find(line) != std::string::npos) ++decks;
  EXPECT_EQ(decks, 5) << line;
}
