// SPDX-License-Identifier: GPL-2.0-only
// `encase run` refuses bad options with one sentence before it runs anything.
#include "support/child_program.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <regex>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const fs::path source = ENCASE_SOURCE;

Outcome run_command(const std::vector<std::string>& options)
{
  std::vector<std::string> words{ENCASE_COMMAND, "run"};
  words.insert(words.end(), options.begin(), options.end());
  return run_program(words, "/");
}

void expect_refused(const std::vector<std::string>& options, const std::string& sentence)
{
  const Outcome outcome = run_command(options);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.output, "encase run: " + sentence + "\n");
}

/// A folder with a deck of its own that says which variables it uses.
void write_deck(const fs::path& folder,
                const std::string& more = "record_variables file variables.csv\n")
{
  std::ofstream(folder / "trial.lmp") << "variable speed index 3  # [m/s] of the trial\n" << more;
}

}  // namespace

TEST(RunCommand, TakesSeveralCasesWrittenOnceOrWithTheOptionRepeated)
{
  const TemporaryFolder folder;
  const std::string out = folder.path() / "out";
  const auto plan = [&](std::vector<std::string> cases) {
    cases.insert(cases.end(), {"--dry-run", "--ranks", "1", "--out", out});
    return run_command(cases);
  };
  const Outcome once = plan({"--case", "plain_050", "plain_100"});
  EXPECT_EQ(once.exit_code, 0) << once.output;
  EXPECT_TRUE(once.says("plain_050")) << once.output;
  EXPECT_TRUE(once.says("plain_100")) << once.output;
  EXPECT_EQ(plan({"--case", "plain_050", "--case", "plain_100"}).exit_code, 0);
}

// The shell only sets up; what shows something does not wait for that.
TEST(RunCommand, ShowsHelpAndCasesFromAnywhere)
{
  setenv("ENCASE_BUILD", fs::path(ENCASE_PROGRAM).parent_path().parent_path().c_str(), 1);
  for (const std::string& start : {(source / "input_scripts/run").string(), std::string()}) {
    const auto outcome = [&](const std::string& option) {
      return start.empty() ? run_command({option}) : run_program({start, option}, "/");
    };
    const Outcome help = outcome("--help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_TRUE(help.says("./input_scripts/run [option ...]")) << help.output;
    const Outcome list = outcome("--list");
    EXPECT_EQ(list.exit_code, 0);
    EXPECT_TRUE(list.says("* plain_050")) << list.output;
    EXPECT_TRUE(list.says("confining stress")) << list.output;
  }
  EXPECT_EQ(run_program({ENCASE_COMMAND, "list"}, "/").output, run_command({"--list"}).output);
}

TEST(RunCommand, ListsEveryVariableWithDefaultUnitAndMeaning)
{
  const std::regex variable(R"(\w+ +((as )?[^ $\[]+ +){1,2}\[[^\]]+\] +[A-Za-z0-9].*)");
  bool among_variables = false;
  int variables = 0;
  for (const std::string& line : run_command({"--list"}).lines()) {
    if (line.rfind("Variables of", 0) == 0)
      among_variables = true;
    else if (line.rfind("variable ", 0) == 0)
      EXPECT_TRUE(std::regex_match(line, std::regex("variable +study +laboratory .*"))) << line;
    else if (among_variables && !line.empty()) {
      ++variables;
      EXPECT_TRUE(std::regex_match(line, variable)) << line;
    }
  }
  EXPECT_GT(variables, 50);
}

TEST(RunCommand, ListsWhatBothSetsOfParametersHave)
{
  const std::string list = run_command({"--list"}).output;
  for (const char* row : {R"(modulus +7e6 +[^ \[]+ +\[Pa\] )", R"(after_strength +warn +[a-z]+ )",
                          R"(sigma3 +50e3 +\[Pa\] )"})
    EXPECT_TRUE(std::regex_search(list, std::regex(row))) << row << " not in\n" << list;
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
  expect_refused({"--resolutoin", "quick"},
                 "unknown option '--resolutoin', nearest is '--resolution', see --help");
}

TEST(RunCommand, RefusesAnOptionWithoutItsValue)
{
  expect_refused({"--case"}, "option '--case' needs a value, see --help");
}

TEST(RunCommand, RefusesAnUnknownCase)
{
  const Outcome outcome = run_command({"--case", "sand"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(
      outcome.says("encase run: unknown case 'sand', expected one of: plain_050 plain_100"));
}

TEST(RunCommand, NamesTheNearestCases)
{
  expect_refused(
      {"--case", "plain_50"},
      "unknown case 'plain_50', nearest are 'plain_050', 'plain_150' and 'plain_100', see --list");
}

TEST(RunCommand, RefusesAnUnknownResolution)
{
  expect_refused({"--resolution", "coarse"},
                 "unknown resolution 'coarse', expected one of: quick standard paper");
}

TEST(RunCommand, RefusesASetOfParametersThatIsNotThere)
{
  expect_refused({"--set", "parameters=labratory"},
                 "unknown parameters 'labratory', expected one of: study laboratory");
}

// A case does not stop half way where a user has written the set of the grains alone.
TEST(RunCommand, RefusesASetOfParametersWithoutItsSleeve)
{
  const TemporaryFolder folder;
  fs::copy(source / "input_scripts/common", folder.path() / "common");
  fs::copy(source / "input_scripts/triaxial_encased/triaxial_encased.lmp", folder.path());
  std::ofstream(folder.path() / "common/parameters_mine.lmp")
      << "variable mu index 0.7 # [-] friction\ninclude ${common}/parameters_study.lmp\n";
  expect_refused(
      {"--deck", folder.path() / "triaxial_encased.lmp", "--set", "parameters=mine"},
      "deck triaxial_encased must find each file of parameters 'mine' in '" +
          (folder.path() / "common").string() +
          "', found no 'sleeve_mine.lmp', write it with the variables of 'sleeve_study.lmp'");
}

TEST(RunCommand, RefusesAVariableTheDeckDoesNotHave)
{
  const Outcome outcome = run_command({"--set", "sigma_3=50e3"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(
      outcome.says("encase run: deck triaxial_plain has no variable 'sigma_3', expected one of: "));
}

TEST(RunCommand, RefusesASettingThatIsNotNameAndValue)
{
  expect_refused({"--set", "sigma3"},
                 "--set takes NAME=VALUE without blanks, found 'sigma3', write for example '--set "
                 "sigma3=50e3'");
}

TEST(RunCommand, RefusesAnUnknownSeries)
{
  const Outcome outcome = run_command({"--series", "plane"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(outcome.says("encase run: unknown series 'plane', expected one of: all plain "));
}

TEST(RunCommand, RefusesASeriesBesideCasesAndRetryWithoutOne)
{
  expect_refused({"--series", "plain", "--case", "plain_050"},
                 "--series and --case both choose cases, found 'plain' and 'plain_050', give one "
                 "of them");
  expect_refused({"--retry"},
                 "--retry belongs to --series, found it alone, leave it out: without a series "
                 "cases run whether they failed before or not");
}

TEST(RunCommand, RefusesOptionsOfSlurmThatCannotBe)
{
  expect_refused({"--slurm-option", "partition=long"},
                 "--slurm-option belongs to --slurm, found 'partition=long' without it, write both "
                 "or none");
  expect_refused({"--slurm", "--slurm-option", "array=1-3"},
                 "--slurm-option leaves out what --slurm itself gives, found 'array', leave it out "
                 "(--ranks and --jobs say how many)");
  expect_refused({"--slurm", "--slurm-option=-p long"},
                 "--slurm-option takes a long option of sbatch, found '-p long', write for example "
                 "'--slurm-option partition=long'");
  expect_refused({"--report-only", "--dry-run"},
                 "--report-only makes tables and report and nothing else, found --dry-run beside "
                 "it, give one of them");
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

TEST(RunCommand, RefusesBothPlacesForResults)
{
  expect_refused({"--name", "trial", "--out", "/tmp/x"},
                 "--out and --name both say where results go, found '/tmp/x' and 'trial', give one "
                 "of them");
}

TEST(RunCommand, RefusesToGoOnWithOtherVariables)
{
  const TemporaryFolder folder;
  const fs::path there = folder.path() / "plain_050";
  fs::create_directories(there);
  std::ofstream(there / "case.json")
      << R"({"id": "plain_050", "deck": "triaxial_plain", "variables": {"resolution": "paper"}})";
  const Outcome outcome = run_command({"--resume", "--out", folder.path(), "--case", "plain_050"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(
      outcome.says("was begun with other variables, found resolution=paper there and "
                   "resolution=quick now, give the same --resolution and --set"))
      << outcome.output;
}

TEST(RunCommand, RefusesToGoOnFromARecordThatIsCutOff)
{
  const TemporaryFolder folder;
  const fs::path there = folder.path() / "plain_050";
  fs::create_directories(there);
  std::ofstream(there / "case.json") << "{\"id\": \"plain_050\",\n";
  const Outcome outcome = run_command({"--resume", "--out", folder.path(), "--case", "plain_050"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(
      outcome.says("found something that is not JSON, run the case again, or leave --resume "
                   "out, and case 'plain_050' begins again"))
      << outcome.output;
  EXPECT_EQ(outcome.lines().size(), 1u);
}

TEST(RunCommand, RefusesAnOutputFolderThatCannotBeWritten)
{
  const TemporaryFolder folder;
  const fs::path in_the_way = folder.path() / "file";
  std::ofstream(in_the_way) << "a file, not a folder\n";
  expect_refused({"--out", in_the_way, "--case", "plain_050"},
                 "cannot write the output folder '" + in_the_way.string() +
                     "', free it or choose another --name or --out");
}

TEST(RunCommand, RefusesACaseOfTheUsersThatIsCalledAsOneOfOurs)
{
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "own.csv") << "id,deck,variables\nplain_050,triaxial_plain,mu=1\n";
  expect_refused(
      {"--cases", folder.path() / "own.csv"},
      "'id' in the file of --cases must be another one than those of our own series.csv, "
      "found 'plain_050', rename that row");
}

TEST(RunCommand, RefusesAnUnknownDeckAndVariableInTheUsersCases)
{
  const TemporaryFolder folder;
  const fs::path own = folder.path() / "own.csv";
  std::ofstream(own) << "id,deck,variables\na,triaxial_plane,mu=1\n";
  expect_refused({"--cases", own},
                 "'deck' of case 'a' in '" + own.string() +
                     "' must be one of column triaxial_encased triaxial_plain or the file "
                     "of your own deck, found 'triaxial_plane', check its name");
  std::ofstream(own) << "id,deck,variables\na,triaxial_plain,my=1\n";
  EXPECT_TRUE(run_command({"--cases", own})
                  .says("encase run: deck triaxial_plain has no variable 'my', expected one of: "));
}

TEST(RunCommand, RefusesADeckThatIsMissingOrDoesNotSayWhatItUses)
{
  const TemporaryFolder folder;
  const fs::path deck = folder.path() / "trial.lmp";
  EXPECT_TRUE(run_command({"--deck", deck}).says("encase run: --deck must be one of "));
  write_deck(folder.path(), "");
  expect_refused({"--deck", deck},
                 "a deck must say which variables it uses, found no 'record_variables' in '" +
                     deck.string() +
                     "', write 'record_variables file variables.csv' behind its last variable");
}

// The deck sets its variable once more than it says: what it used is known from the run alone.
TEST(RunCommand, FailsACaseThatUsesAnotherValueThanItWasAskedFor)
{
  const TemporaryFolder folder;
  write_deck(
      folder.path(),
      "variable speed delete\nvariable speed index 4\nrecord_variables file variables.csv\n");
  const Outcome outcome = run_command({"--deck", folder.path() / "trial.lmp", "--out",
                                       folder.path() / "out", "--set", "speed=5", "--no-pictures"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(
      outcome.says("variable 'speed' of case 'trial' must be used as it was asked for, "
                   "found 4 in the run and 5 asked for"))
      << outcome.output;
}

// A file in common/ makes a set: its name is enough. What it leaves to the study is the study's.
TEST(RunCommand, TakesASetOfTheUsersByItsName)
{
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "common");
  std::ofstream(folder.path() / "common/parameters_study.lmp")
      << "variable speed index 3  # [m/s] of the trial\nvariable mass index 2  # [kg] of it\n";
  std::ofstream(folder.path() / "common/parameters_mine.lmp")
      << "variable mass index 5  # [kg] measured\ninclude ${common}/parameters_study.lmp\n";
  std::ofstream(folder.path() / "trial.lmp") << "variable parameters index study  # [-] set\n"
                                                "include ${common}/parameters_${parameters}.lmp\n"
                                                "record_variables file variables.csv\n";
  const Outcome outcome =
      run_command({"--deck", folder.path() / "trial.lmp", "--out", folder.path() / "out", "--set",
                   "parameters=mine", "--set", "speed=4", "--no-pictures"});
  EXPECT_TRUE(outcome.says("Case trial finished in ")) << outcome.output;
  const std::string record = read_text(folder.path() / "out/trial/case.json");
  EXPECT_NE(record.find("\"variables\": {\n  \"parameters\": \"mine\",\n  \"mass\": 5,\n  "
                        "\"speed\": 4\n"),
            std::string::npos)
      << record;
}

// Each row of series.csv names a deck that lies beside the program, and variables that it has; the
// deck tells grains, steps, time and disk of the row.
TEST(RunCommand, FindsTheDeckOfEveryRowAndItsSize)
{
  const TemporaryFolder folder;
  const Outcome outcome =
      run_command({"--series", "all", "--dry-run", "--out", folder.path() / "out"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  std::ifstream series(source / "input_scripts/series.csv");
  std::string row;
  std::getline(series, row);
  std::size_t rows = 0;
  while (std::getline(series, row)) {
    ++rows;
    const std::string number = "[1-9][0-9 ]*", time = "([0-9]+ h )?[0-9]+ (s|min)";
    const std::regex known("\n" + row.substr(0, row.find(',')) + " +" + number + "  +" + number +
                           "  +" + time + "  +[0-9.]+ [MG]B *\n");
    EXPECT_TRUE(std::regex_search(outcome.output, known)) << row << " not in\n" << outcome.output;
  }
  EXPECT_GE(rows, 36u);
  EXPECT_FALSE(outcome.says("unknown")) << outcome.output;
}

// By the definition of relative density, e = e_max - D_r (e_max - e_min), the grains of a column
// are as 1 - n = 1 / (1 + e): between the row of packing_limits.csv for S1 and the set's friction.
TEST(RunCommand, PacksAColumnByRelativeDensity)
{
  const auto grains_at = [](const std::string& density) {
    const TemporaryFolder folder;
    const Outcome outcome = run_command({"--case", "column", "--set", "relative_density=" + density,
                                         "--dry-run", "--out", folder.path() / "out"});
    std::smatch found;
    const std::regex row("\ncolumn +([0-9 ]+[0-9])  ");
    EXPECT_TRUE(std::regex_search(outcome.output, found, row)) << outcome.output;
    std::string digits = found[1];
    digits.erase(std::remove(digits.begin(), digits.end(), ' '), digits.end());
    return std::stod(digits);
  };
  const double loosest = 0.482, densest = 0.3754;
  const double loose = loosest / (1.0 - loosest), dense = densest / (1.0 - densest);
  for (const double d : {0.4, 0.8})
    EXPECT_NEAR(grains_at(d < 0.5 ? "0.4" : "0.8") / grains_at("0"),
                (1.0 + loose) / (1.0 + loose - d * (loose - dense)), 1e-3);
}

TEST(RunCommand, RecordsWhatTheRunUsed)
{
  const TemporaryFolder folder;
  write_deck(folder.path());
  const Outcome outcome = run_command({"--deck", folder.path() / "trial.lmp", "--out",
                                       folder.path() / "out", "--set", "speed=5", "--no-pictures"});
  EXPECT_TRUE(outcome.says("Case trial finished in ")) << outcome.output;
  const std::string record = read_text(folder.path() / "out/trial/case.json");
  EXPECT_NE(record.find("\"variables\": {\n  \"speed\": 5"), std::string::npos) << record;
}
