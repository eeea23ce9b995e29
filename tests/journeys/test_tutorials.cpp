// What reads and follows the tutorials must see a step that fails; the shorter tutorials are
// followed here.
#include "support/child_program.h"
#include "support/csv_table.h"
#include "support/tutorial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const fs::path tutorials = fs::path(ENCASE_SOURCE) / "input_scripts/tutorials";

/// What goes wrong on a page of this text.
std::string problem_of(const std::string& text)
{
  const TemporaryFolder home;
  const fs::path page = home.path() / "page.md";
  std::ofstream(page) << text;
  return follow(read_steps(page), home.path(), home.path());
}

bool has(const std::string& text, const std::string& words)
{
  return text.find(words) != std::string::npos;
}

}  // namespace

TEST(TutorialSteps, WriteFilesAndGoOnInTheFolderAndWithTheVariablesOfTheLast)
{
  EXPECT_EQ(
      problem_of("# A\n```sh\nexport WORD=\"two words\"\nmkdir deep\ncd deep\n```\n"
                 "```csv file=a.csv\n1,2\n```\n```csv file=a.csv\n3\n```\n"
                 "```sh\ncat a.csv; echo $WORD; basename $PWD\ncat ../deep/a.csv | wc -l\n```\n"
                 "```output\n1,2\n3\ntwo...rds\ndeep\n2\n```\n"),
      "");
}

TEST(TutorialSteps, ChangeLinesOfAnotherFile)
{
  const std::string old = "# A\n```text file=old\na\nb\nc\n```\n";
  EXPECT_EQ(problem_of(old + "```diff file=new from=old\n-b\n-a\n+d\n+e\n```\n```sh\ncat new\n```\n"
                             "```output\nd\ne\nc\n```\n"),
            "");
  EXPECT_TRUE(has(problem_of(old + "```diff file=new from=old\n-f\n```\n"),
                  "line 7: there is no line 'f'"));
}

TEST(TutorialSteps, ThatFailAreFoundWithTheirLine)
{
  EXPECT_TRUE(has(problem_of("# A\n```sh\ntrue\nfalse\ntrue\n```\n"), "line 2: exit code 1"));
  EXPECT_TRUE(has(problem_of("# A\n```sh\nno_such_program | cat\n```\n"), "line 2: exit code 127"));
  EXPECT_TRUE(has(problem_of("```sh\necho b; echo a\n```\n```output\na\nb\n```\n"),
                  "line 4: 'b' is not in its place"));
  EXPECT_THROW(problem_of("```sh\necho a\n"), std::runtime_error);
}

TEST(TutorialSteps, AreLeftOutWhereSomethingIsMissingOrByHand)
{
  EXPECT_EQ(problem_of("```sh needs=no_such_program\nfalse\n```\n```output\nnever\n```\n"
                       "```sh by_hand\nfalse\n```\n```output\nnever\n```\n"),
            "");
  EXPECT_NE(problem_of("```sh needs=bash\nfalse\n```\n"), "");
}

TEST(TutorialSteps, OfASectionAreThoseUnderItsHeading)
{
  const TemporaryFolder folder;
  const fs::path page = folder.path() / "page.md";
  std::ofstream(page) << "# A\n```sh\na\n```\n## B\n```sh\n# c\n```\n### C\n```sh\nd\n```\n## E\n"
                         "```sh\ne\n```\n";
  const auto steps = read_steps(page, "B");
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].text, "# c\n");
  EXPECT_EQ(steps[1].text, "d\n");
  EXPECT_EQ(read_steps(page).size(), 4u);
  EXPECT_THROW(read_steps(page, "D"), std::runtime_error);
}

// The history of the deck is held against what the page says in words: 100 kPa around, 2e-6 m per
// step over 5 000 steps of a specimen near 200 mm, a sleeve free of stress at its start.
TEST(Tutorials, BuildADeckOfOnesOwnFromAnEmptyFile)
{
  const TemporaryFolder home;
  ASSERT_EQ(follow(read_steps(tutorials / "own_deck.md"), home.path(), clone_in(home.path())), "");
  const CsvTable history(home.path() / "column/history.csv");
  const auto last = [&](const std::string& name) { return history.column(name).back(); };
  EXPECT_EQ(history.rows(), 101u);
  const double height = history.column("height [m]").front();
  EXPECT_NEAR(height, 0.200, 0.002);
  EXPECT_NEAR(height - last("height [m]"), 5000 * 2e-6, 1e-9);
  EXPECT_NEAR(last("confining_stress [Pa]"), 100e3, 1.0);
  EXPECT_NEAR(history.column("deviatoric_stress_top [Pa]").front(), 0.0, 5e3);
  // The platens agree as the sleeve is symmetric, and the ends slide.
  EXPECT_NEAR(last("stress_top [Pa]") / last("stress_bottom [Pa]"), 1.0, 0.05);
  EXPECT_LT(std::abs(last("energy_error [-]")), 0.01);
  const CsvTable sleeve(home.path() / "column/sleeve.csv");
  // J = 120 kN/m: tension is no more than that times the strain.
  EXPECT_LE(sleeve.column("hoop_tension_mean [N/m]").back(),
            120e3 * sleeve.column("hoop_strain_mean [-]").back() / (1.0 - 0.3 * 0.3));
  EXPECT_GT(sleeve.column("hoop_tension_mean [N/m]").back(), 500.0);
}
