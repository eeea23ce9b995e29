// SPDX-License-Identifier: GPL-2.0-only
// `encase calibrate` as a user meets it, with a small program in place of decks.
#include "runs/run_store.h"
#include "support/child_program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <thread>

#include <sys/wait.h>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

/// Writes a.yaml: two parameters of the program `hyperbola`, 20 points of which one has two
/// packings, and a round with three runs.
void write_config(const fs::path& folder, const std::string& high = "800 kPa")
{
  std::ofstream(folder / "cases.csv") << "id,deck,variables\none,none,sigma3=100e3\n";
  std::ofstream(folder / "a.yaml")
      << "name: small\nruns:\n  program: [" << HYPERBOLA << ", " << (folder / "starts").string()
      << "]\n  cases_file: cases.csv\n  cases: one\n  jobs: 2\nparameters:\n"
         "  - {name: stiffness, low: 10 MPa, high: 40 MPa, unit: Pa}\n"
         "  - {name: strength, low: 200 kPa, high: "
      << high
      << ", unit: Pa}\ntargets:\n"
         "  - {quantity: secant_modulus, case: one, value: 12 MPa, tolerance: 0.1 %}\n"
         "  - {quantity: peak_q, case: one, value: 350 kPa, tolerance: 0.1 %}\n"
         "design: {points: 20, repeated: 1, repeats: 2}\n"
         "search: {surrogates: [regression], folds: 4, rounds: 1, candidates: 2, samples: 400}\n";
}

constexpr long all_runs = 21 + 3;

long lines_in(const fs::path& file)
{
  std::ifstream stream(file);
  long lines = 0;
  for (std::string line; std::getline(stream, line);) ++lines;
  return lines;
}

std::vector<std::string> words(const std::vector<std::string>& more)
{
  std::vector<std::string> all{ENCASE_COMMAND, "calibrate", "a.yaml", "--out", "out"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace

TEST(CalibrateCommand, KilledItGoesOnAndLosesAtMostTheRunsInFlight)
{
  const TemporaryFolder whole, killed;
  for (const TemporaryFolder* one : {&whole, &killed}) write_config(one->path());
  const Outcome first = run_program(words({}), whole.path());
  ASSERT_EQ(first.exit_code, 0) << first.output;
  EXPECT_EQ(lines_in(whole.path() / "starts"), all_runs);

  for (const long after : {4L, 23L}) {  // in the design, in the round of candidates
    const pid_t child = fork();
    if (child == 0) {
      if (chdir(killed.path().c_str()) != 0) _exit(1);
      dup2(open("/dev/null", 1), 1);
      execl(CALIBRATE_PROGRAM, "encase-calibrate", "a.yaml", "--out", "out",
            after > 4 ? "--resume" : nullptr, nullptr);
      _exit(127);
    }
    for (int waited = 0; waited < 6000 && lines_in(killed.path() / "starts") < after; ++waited)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    EXPECT_LT(RunStore(killed.path() / "out/runs.sqlite").run_count(), all_runs);
  }
  const Outcome again = run_program(words({"--resume"}), killed.path());
  ASSERT_EQ(again.exit_code, 0) << again.output;
  EXPECT_LE(lines_in(killed.path() / "starts"), all_runs + 2 * 2);  // two at once, twice
  EXPECT_GE(lines_in(killed.path() / "starts"), all_runs);
  for (const char* file : {"parameters.txt", "parameters_small.lmp"})
    EXPECT_EQ(read_text(killed.path() / "out" / file), read_text(whole.path() / "out" / file))
        << file;

  const Outcome third = run_program(words({}), killed.path());
  EXPECT_EQ(third.exit_code, 1);
  EXPECT_TRUE(
      third.says("encase calibrate: a calibration must not begin twice in one folder, found one "
                 "in 'out', write --resume to go on, or another --out"))
      << third.output;
}

// q = strain / (1 / K + strain / S): E50 and peak at 20 % give K and S in closed form. With
// r = peak / 2: strain50 = r / K / (1 - r / S), E50 = K (1 - r / S).
TEST(CalibrateCommand, ReportsFilesTheParametersAndFailedRuns)
{
  const TemporaryFolder folder;
  write_config(folder.path(), "1000 kPa");
  const Outcome outcome = run_program(words({}), folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_TRUE(outcome.says(" failed and is left out: exit code 3 of '")) << outcome.output;
  EXPECT_TRUE(outcome.says("Round 1: 24 runs")) << outcome.output;

  double strength = 400e3, stiffness = 20e6;
  for (int n = 0; n < 200; ++n) {  // peak = 0.2 / (1 / K + 0.2 / S) = 350 kPa, E50 = 12 MPa
    stiffness = 12e6 / (1.0 - 175e3 / strength);
    strength = 0.2 / (0.2 / 350e3 - 1.0 / stiffness);
  }
  // `strength` is a variable of the sleeve, which has a file of its own.
  const std::string grains = read_text(folder.path() / "out/parameters_small.lmp"),
                    sleeve = read_text(folder.path() / "out/sleeve_small.lmp");
  const auto value = [&](const std::string& file, const std::string& name) {
    const std::string start = "variable " + name + " index ";
    const std::size_t at = file.find(start);
    return at == std::string::npos ? 0.0 : std::atof(file.c_str() + at + start.size());
  };
  EXPECT_NEAR(value(grains, "stiffness"), stiffness, 0.02 * stiffness) << grains;
  EXPECT_NEAR(value(sleeve, "strength"), strength, 0.02 * strength) << sleeve;
  EXPECT_NE(grains.find("include ${common}/parameters_laboratory.lmp\n"), std::string::npos);

  const std::string page = read_text(folder.path() / "out/report.html");
  for (const char* part : {"<h1>Calibration: small</h1>", "Failed runs, left out", "exit code 3 of",
                           "Sobol indices of", "Cross-validation", "Parameters against one another",
                           "secant_modulus of one", "24 runs, "})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_EQ(page.find("{{"), std::string::npos);

  const Outcome report = run_program(words({"--report"}), folder.path());
  EXPECT_EQ(report.exit_code, 0) << report.output;
  EXPECT_EQ(read_text(folder.path() / "out/report.html"), page);
}

// A known point that is added to a calibration that has ended is run, and is the best there is.
TEST(CalibrateCommand, RunsAKnownPointWithAllPackingsWhenItGoesOn)
{
  const TemporaryFolder folder;
  write_config(folder.path());
  ASSERT_EQ(run_program(words({}), folder.path()).exit_code, 0);
  // E50 = K (1 - peak / 2 S) and peak = 0.2 / (1 / K + 0.2 / S), as in ReportsFilesTheParameters.
  std::ofstream(folder.path() / "a.yaml", std::ios::app)
      << "known:\n  - {stiffness: 22.25 MPa, strength: 379.9 kPa}\n";
  const Outcome outcome = run_program(words({"--resume"}), folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_TRUE(outcome.says("Runs to make: 2")) << outcome.output;
  EXPECT_TRUE(outcome.says("stiffness  22.25 MPa")) << outcome.output;
  EXPECT_TRUE(outcome.says("strength   379.9 kPa")) << outcome.output;
  EXPECT_EQ(lines_in(folder.path() / "starts"), all_runs + 2);
  EXPECT_EQ(run_program(words({"--resume"}), folder.path()).exit_code, 0);
  EXPECT_EQ(lines_in(folder.path() / "starts"), all_runs + 2);
}

TEST(CalibrateCommand, RefusesBeforeItRuns)
{
  const TemporaryFolder folder;
  write_config(folder.path());
  const auto expect = [&](const std::vector<std::string>& more, const std::string& sentence) {
    const Outcome outcome = run_program(words(more), folder.path());
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.output, "encase calibrate: " + sentence + "\n");
  };
  expect({"--report"},
         "--report takes a calibration that has run, found none in 'out', leave --report out");
  expect({"--slurm"},
         "--slurm belongs to 'program: encase', found another program in 'a.yaml', leave it out");
  std::ofstream(folder.path() / "cases.csv") << "id,deck,variables\nother,none,\n";
  expect({}, "unknown case 'one' in 'cases' of 'a.yaml', expected one of: other");
  EXPECT_FALSE(fs::exists(folder.path() / "starts"));
  EXPECT_TRUE(
      run_program({ENCASE_COMMAND, "calibrate", "--help"}, "/").says("YAML file that says"));
}

TEST(CalibrateCommand, SaysWhereItWasNotBuilt)
{
  const TemporaryFolder folder;
  fs::copy_file(ENCASE_COMMAND, folder.path() / "encase");
  const Outcome outcome =
      run_program({folder.path() / "encase", "calibrate", "a.yaml"}, folder.path());
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(
      outcome.output,
      "encase calibrate: it needs the program 'encase-calibrate', which is built where "
      "libopenturns-dev, libyaml-cpp-dev, libsqlitecpp-dev and libfann-dev are installed, found "
      "none in '.', write './calibration/run CONFIG' in the folder of the project, which sets up "
      "what is missing, or install the Debian package 'encased-columns-calibration'\n");
}

TEST(RunStore, KeepsPointsAndRunsAndRefusesOthers)
{
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "runs.sqlite";
  {
    RunStore store(file);
    store.identify("modulus from 1 to 2\nmu from 0 to 1\n");
    store.add_points({{0, "design", 0, 2, Eigen::Vector2d(0.25, 0.5)}});
    store.add_points({{0, "candidate", 3, 1, Eigen::Vector2d(1.0 / 3.0, 1.0)}});
    RunResult good;
    good.seconds = 2.5;
    good.strain = {0.0, 0.1};
    good.stress = {0.0, 1e5 / 3.0};
    good.values["peak_q"] = 1e5 / 3.0;
    store.record({0, 1, "one"}, good);
    RunResult bad;
    bad.problem = "a grain was lost";
    store.record({1, 0, "one"}, bad);
  }
  RunStore store(file);
  store.identify("modulus from 1 to 2\nmu from 0 to 1\n");
  const auto points = store.points();
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[1].id, 1);
  EXPECT_EQ(points[1].round, 3);
  EXPECT_EQ(points[1].point, Eigen::Vector2d(1.0 / 3.0, 1.0));
  EXPECT_EQ(points[0].repeats, 2);
  auto runs = store.runs();
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ((runs[{0, 1, "one"}].values.at("peak_q")), 1e5 / 3.0);
  EXPECT_EQ((runs[{0, 1, "one"}].stress.back()), 1e5 / 3.0);
  EXPECT_EQ((runs[{1, 0, "one"}].problem), "a grain was lost");
  try {
    store.identify("modulus from 1 to 2\nmu from 0 to 0.9\n");
    FAIL();
  } catch (const std::exception& problem) {
    EXPECT_STREQ(
        problem.what(),
        "a calibration goes on with the same parameters, cases and variables, found 'mu from 0 "
        "to 0.9' where its runs were made with 'mu from 0 to 1', give it another 'name' or "
        "--out");
  }
  store.forget_failed();
  EXPECT_EQ(store.run_count(), 1);
}
