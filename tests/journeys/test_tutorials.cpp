// SPDX-License-Identifier: GPL-2.0-only
// What reads and follows the tutorials must see a step that fails; the shorter tutorials are
// followed here.
#include "support/child_program.h"
#include "support/csv_table.h"
#include "support/run_command.h"
#include "support/tutorial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

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

/// The rows "| `a` | `b` |..." of a page, as pairs.
std::vector<std::pair<std::string, std::string>> pairs_on(const fs::path& page)
{
  std::vector<std::pair<std::string, std::string>> pairs;
  std::istringstream stream(read_text(page));
  for (std::string line; std::getline(stream, line);) {
    const std::size_t bar = line.find("` | `");
    if (line.rfind("| `", 0) != 0 || bar == std::string::npos) continue;
    pairs.emplace_back(line.substr(3, bar - 3),
                       line.substr(bar + 5, line.find('`', bar + 5) - bar - 5));
  }
  return pairs;
}

/// The text of the first VTK file of a series in `folder`.
std::string first_picture(const fs::path& folder)
{
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".vtp") return read_text(entry.path());
  return "";
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

TEST(Tutorials, ReadARun)
{
  const TemporaryFolder home;
  const fs::path clone = clone_in(home.path()), page = tutorials / "reading_a_run.md";
  prepare_small_cases(home.path());
  const Outcome outcome =
      RunningCommand(home.path(), "out", {"--case", "encased", "--ranks", "1"}).end();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const fs::path run = clone / "runs/default/encased_050";
  fs::create_directories(run.parent_path());
  fs::rename(home.path() / "out/encased", run);
  ASSERT_EQ(follow(read_steps(page), home.path(), clone), "");

  int columns = 0, arrays = 0;
  for (const auto& [where, name] : pairs_on(page)) {
    if (fs::path(where).extension() == ".csv") {
      ++columns;
      EXPECT_NO_THROW(CsvTable(run / where).column(name)) << name << " of " << where;
    } else {
      ++arrays;
      EXPECT_TRUE(has(first_picture(run / where), "Name=\"" + name + "\""))
          << name << " of " << where;
    }
  }
  EXPECT_GE(columns, 14);
  EXPECT_GE(arrays, 8);

  const Outcome peak = run_program({"python3", "curve.py"}, run);
  if (peak.exit_code == 127) GTEST_SKIP() << "found no python3";
  const std::vector<double> q =
      CsvTable(run / "history.csv").column("deviatoric_stress_bottom [Pa]");
  char words[80];
  std::snprintf(words, sizeof words, "peak q %.1f kPa",
                *std::max_element(q.begin(), q.end()) / 1e3);
  EXPECT_TRUE(peak.says(words)) << words << " not in " << peak.output;
}

TEST(Tutorials, AddATestOfOnesOwnToASeries)
{
  const TemporaryFolder home;
  const fs::path page = fs::path(ENCASE_SOURCE) / "input_scripts/README.md";
  const auto steps = read_steps(page, "Adding a test of your own");
  clone_in(home.path());
  setenv("PATH", (fs::path(ENCASE_COMMAND).parent_path().string() + ":" + getenv("PATH")).c_str(),
         1);
  ASSERT_EQ(follow(steps, home.path(), home.path()), "");
  long lines = 0;
  for (const TutorialStep& step : steps)
    if (step.words.count("file") || step.kind == "sh")
      lines += std::count(step.text.begin(), step.text.end(), '\n');
  EXPECT_LE(lines, 10);
  for (const std::string id : {"short", "stiff"}) {
    const CsvTable history(home.path() / "runs/mine" / id / "history.csv");
    EXPECT_NEAR(history.column("height [m]").front(), 0.06, 0.002) << id;
    EXPECT_NEAR(history.column("confining_stress [Pa]").back(), 75e3, 75.0) << id;
  }
}
