// SPDX-License-Identifier: GPL-2.0-only
// The program `encase` tells what it is, what it knows, and what the machine lacks; a wrong word is
// answered with one sentence.
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

Outcome encase(std::vector<std::string> words)
{
  words.insert(words.begin(), ENCASE_COMMAND);
  return run_program(words, "/");
}

/// The line of `outcome` that begins with `start`.
std::string line_of(const Outcome& outcome, const std::string& start)
{
  for (const std::string& line : outcome.lines())
    if (line.rfind(start, 0) == 0) return line;
  return "";
}

}  // namespace

TEST(Program, TellsItsVersionCommitHostCompilerAndMpi)
{
  const Outcome outcome = encase({"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  const std::vector<std::string> lines = outcome.lines();
  ASSERT_EQ(lines.size(), 4u) << outcome.output;
  std::string version;
  std::ifstream project(fs::path(ENCASE_SOURCE) / "CMakeLists.txt");
  for (std::string line; std::getline(project, line) && version.empty();)
    if (line.rfind("project(", 0) == 0)
      version = std::regex_replace(line, std::regex(".*VERSION ([0-9.]+) .*"), "$1");
  std::string commit =
      run_program({"git", "-C", ENCASE_SOURCE, "rev-parse", "--short", "HEAD"}, "/").output;
  commit = std::regex_match(commit, std::regex("[0-9a-f]+\n")) ? commit.substr(0, commit.size() - 1)
                                                               : "unknown";
  EXPECT_EQ(lines[0], "encase " + version + ", commit " + commit);
  EXPECT_EQ(lines[1], "host: LIGGGHTS 3.8.0");
  EXPECT_TRUE(std::regex_match(lines[2], std::regex("compiler: \\w+ [0-9.]+"))) << lines[2];
  EXPECT_TRUE(std::regex_match(lines[3], std::regex("MPI: .+"))) << lines[3];
}

TEST(Program, RefusesAnUnknownCommandWithTheNearest)
{
  const Outcome outcome = encase({"stiles"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.output,
            "encase stiles: unknown command 'stiles', nearest is 'styles', see --help\n");
}

TEST(Program, ListsEveryStyleWithASentence)
{
  const Outcome outcome = encase({"styles"});
  EXPECT_EQ(outcome.exit_code, 0);
  for (const std::string& line : run_program({ENCASE_PROGRAM, "-styles"}, "/").lines()) {
    const std::string command = "command ";
    if (line.empty() || line[0] == '|' || line.rfind("table ", 0) == 0) continue;
    const std::string name = line.rfind(command, 0) == 0 ? line.substr(command.size()) : line;
    EXPECT_TRUE(std::regex_search(outcome.output, std::regex("(^|\n)" + name + "  +[A-Z].*\\.")))
        << name;
  }
  EXPECT_FALSE(line_of(outcome, "pair_style gran model linear  ").empty()) << outcome.output;
}

TEST(Program, ExplainsStylesKeywordsColumnsAndVariables)
{
  EXPECT_TRUE(encase({"explain", "servo/platen"}).says("\n  position "));
  EXPECT_TRUE(encase({"explain", "fix", "specimen/history"}).says("\nColumns of history.csv:\n"));
  const Outcome porosity = encase({"explain", "porosity"});
  EXPECT_FALSE(line_of(porosity, "keyword of create_packing  ").empty()) << porosity.output;
  EXPECT_FALSE(line_of(porosity, "column of spheres.csv, fix measure/sphere  ").empty());
  const std::string variable =
      line_of(porosity, "variable of deck triaxial_plain, --set porosity=VALUE  ");
  EXPECT_TRUE(
      std::regex_search(variable, std::regex("study 0.20, laboratory 0\\.\\d+ +\\[-\\]  at")))
      << porosity.output;
}

TEST(Program, AnswersAWordItDoesNotKnowWithTheNearest)
{
  const Outcome outcome = encase({"explain", "raduis"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(
      outcome.output,
      "encase explain: the word must be a style, a keyword, a column or a variable of a deck, "
      "found 'raduis', nearest is 'radius', write 'encase styles' to see all styles\n");
  EXPECT_EQ(encase({"explain"}).output, "encase explain: word is required, see --help\n");
}

// With no program along PATH there is neither mpirun nor xvfb-run.
TEST(Program, SaysWhatAMachineLacks)
{
  const TemporaryFolder folder;
  const auto doctor = [&](const std::string& setting) {
    return run_program(
        {"env", "-u", "DISPLAY", "-u", "ENCASE_SOURCE", setting, ENCASE_COMMAND, "doctor"},
        folder.path());
  };
  const Outcome outcome = doctor("PATH=" + folder.path().string());
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(outcome.says("found none, write 'apt-get install openmpi-bin'")) << outcome.output;
  EXPECT_TRUE(outcome.says("found neither, write 'apt-get install xvfb xauth'")) << outcome.output;
  EXPECT_TRUE(outcome.says("2 things need mending")) << outcome.output;

  const Outcome closed = doctor("DISPLAY=:98");
  EXPECT_EQ(closed.exit_code, 1);
  EXPECT_TRUE(closed.says("found that ':98' cannot be opened")) << closed.output;
  EXPECT_FALSE(line_of(closed, "ok    MPI ").empty()) << closed.output;
  EXPECT_FALSE(line_of(closed, "ok    programs ").empty()) << closed.output;
}
