// The command input_scripts/run refuses bad options with one sentence before it sets anything up.
#include "support/child_program.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <regex>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const fs::path source = ENCASE_SOURCE;

Outcome run_command(const std::vector<std::string>& options)
{
  std::vector<std::string> words{source / "input_scripts/run"};
  words.insert(words.end(), options.begin(), options.end());
  return run_program(words, "/");
}

void expect_refused(const std::vector<std::string>& options, const std::string& sentence)
{
  const Outcome outcome = run_command(options);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.output, "run: " + sentence + "\n");
}

}  // namespace

TEST(RunCommand, ShowsHelpAndCasesFromAnywhere)
{
  const Outcome help = run_command({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_TRUE(help.says("./input_scripts/run [option ...]"));
  const Outcome list = run_command({"--list"});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_TRUE(list.says("* plain_050")) << list.output;
  EXPECT_TRUE(list.says("confining stress")) << list.output;
}

TEST(RunCommand, ListsEveryVariableWithDefaultUnitAndMeaning)
{
  const std::regex variable(R"(\w+ +(as )?[^ $]+ +\[[^\]]+\] +[A-Za-z0-9].*)");
  bool among_variables = false;
  int variables = 0;
  for (const std::string& line : run_command({"--list"}).lines()) {
    if (line.rfind("Variables of", 0) == 0)
      among_variables = true;
    else if (among_variables && !line.empty()) {
      ++variables;
      EXPECT_TRUE(std::regex_match(line, variable)) << line;
    }
  }
  EXPECT_GT(variables, 50);
}

TEST(RunCommand, ListsFilesToReadByTheirPathInTheProject)
{
  const std::string list = run_command({"--list"}).output;
  const std::regex page(R"([\w/]+\.md)");
  int pages = 0;
  for (std::sregex_iterator found(list.begin(), list.end(), page), end; found != end; ++found) {
    ++pages;
    EXPECT_TRUE(fs::exists(source / found->str())) << found->str();
    EXPECT_NE(found->suffix().str().rfind(" here", 0), 0u) << found->str();
  }
  EXPECT_GT(pages, 3);
}

TEST(RunCommand, RefusesAnUnknownOption)
{
  expect_refused({"--resolutoin", "quick"}, "unknown option '--resolutoin', see --help");
}

TEST(RunCommand, RefusesAnOptionWithoutItsValue)
{
  expect_refused({"--case"}, "option '--case' needs a value, see --help");
}

TEST(RunCommand, RefusesAnUnknownCase)
{
  const Outcome outcome = run_command({"--case", "plain_51"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(outcome.says("run: unknown case 'plain_51', expected one of: plain_050 plain_100"));
}

TEST(RunCommand, RefusesAnUnknownResolution)
{
  expect_refused({"--resolution", "coarse"},
                 "unknown resolution 'coarse', expected one of: quick standard paper");
}

TEST(RunCommand, RefusesAVariableTheDeckDoesNotHave)
{
  const Outcome outcome = run_command({"--set", "sigma_3=50e3"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(
      outcome.says("run: deck triaxial_plain has no variable 'sigma_3', expected one of: "));
}

TEST(RunCommand, RefusesASettingThatIsNotNameAndValue)
{
  expect_refused({"--set", "sigma3"},
                 "--set takes NAME=VALUE without blanks, found 'sigma3', write for example '--set "
                 "sigma3=50e3'");
}

TEST(RunCommand, RefusesRanksThatAreNotAWholeNumber)
{
  expect_refused({"--ranks", "1.5"},
                 "--ranks takes a whole number from 1, found '1.5', write for example '--ranks 2'");
}

TEST(RunCommand, RefusesANameThatLeavesTheRunFolder)
{
  expect_refused({"--name", "../elsewhere"},
                 "--name takes letters, digits, '_', '-' and '.', found '../elsewhere', write for "
                 "example '--name trial_2'");
}

TEST(RunCommand, RefusesToGoOnWithOtherVariables)
{
  const std::string name = "begun_" + std::to_string(getpid());
  const fs::path folder = source / "runs" / name;
  fs::create_directories(folder / "plain_050");
  std::ofstream(folder / "plain_050/case.json") << "{\"id\": \"plain_050\",\n";
  const Outcome outcome = run_command({"--resume", "--name", name, "--case", "plain_050"});
  fs::remove_all(folder);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(outcome.says("run: case 'plain_050' in 'runs/" + name +
                           "' was begun with other variables, found "))
      << outcome.output;
  EXPECT_TRUE(outcome.says("give the same --resolution and --set or another --name"));
}

TEST(RunCommand, RefusesAnOutputFolderThatCannotBeWritten)
{
  const std::string name = "blocked_" + std::to_string(getpid());
  const fs::path in_the_way = source / "runs" / name;
  fs::create_directories(in_the_way.parent_path());
  std::ofstream(in_the_way) << "a file, not a folder\n";
  expect_refused({"--name", name, "--case", "plain_050"},
                 "cannot write the output folder 'runs/" + name +
                     "/plain_050', free it or choose another --name");
  fs::remove(in_the_way);
}

// With the same variables the same results come again, and nothing needs to be said.
TEST(RunCommand, SaysThatResultsOfOtherVariablesGo)
{
  const TemporaryFolder folder;
  const Outcome outcome = run_program({"bash", "-c",
                                       "set -euo pipefail; root=" + source.string() +
                                           "; source $root/input_scripts/run_case\n"
                                           "case_json() { echo now; }\n"
                                           "series=$PWD resume=0; mkdir one; touch one/finished\n"
                                           "echo now >one/case.json; announce_case one\n"
                                           "echo before >one/case.json; announce_case one\n"},
                                      folder.path());
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.output,
            "Case one begins anew with other variables; its results go (another --name would keep "
            "them)\n");
}
