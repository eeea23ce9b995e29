// SPDX-License-Identifier: GPL-2.0-only
// An encased specimen that stops, is written to a file and goes on in a new process is the same
// specimen, bit by bit.
#include "restart/encased_deck.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

void run_in(const fs::path& folder, const std::string& deck)
{
  const Outcome outcome = run_deck(deck, 1, folder);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
}

std::string rest(const std::string& file)
{
  return "run 300\n" + picture(file) + sleeve_numbers(file);
}

void expect_the_same_run(const std::string& before, const std::string& again)
{
  const TemporaryFolder folder;
  run_in(folder.path(), new_encased_specimen(before + "write_restart stop\n" + rest("whole")));
  run_in(folder.path(), encased_specimen_of("stop", again + rest("parts")));
  EXPECT_GT(fs::file_size(folder.path() / "whole"), 10000u);
  EXPECT_EQ(read_text(folder.path() / "parts"), read_text(folder.path() / "whole"));
}

}  // namespace

TEST(EncasedRestart, GoesOnInTheRampOfThePressure)
{
  std::string ramp = encased_consolidation;
  ramp.replace(ramp.find("run 2000"), 8, "run 437");
  expect_the_same_run(ramp, "");
}

TEST(EncasedRestart, GoesOnInShearAndWithTheHistory)
{
  expect_the_same_run(encased_shear + "run 413\n", "");
}

// Part of the facets have yielded, or begun to tear and are not through. With a fracture energy of
// 0.3 N the sleeve bursts in its consolidation, and whether a grain then gets through it is chance:
// it was of round-off.
TEST(EncasedRestart, GoesOnInsideATear)
{
  for (const std::string after :
       {"after_strength yield", "after_strength tear fracture_energy 1 when_torn go_on"}) {
    const std::string cloth = "tension_only yes strain_limit 5 strength 70 70 seam 0.9 " + after;
    const TemporaryFolder folder;
    const std::string damage =
        "variable plastic equal f_side[16]\nvariable damage equal f_side[17]\n"
        "print \"plastic ${plastic}\"\nprint \"damage ${damage}\"\n";
    const Outcome first = run_deck(
        new_encased_specimen(
            encased_shear + "run 413\nwrite_restart stop\n" + damage + rest("whole"), cloth),
        1, folder.path());
    ASSERT_EQ(first.exit_code, 0) << first.output;
    EXPECT_GT(first.value("plastic") + first.value("damage"), 0.0) << first.output;
    EXPECT_LT(first.value("damage"), 0.9999) << "torn through";
    run_in(folder.path(), encased_specimen_of("stop", rest("parts"), cloth));
    EXPECT_EQ(read_text(folder.path() / "parts"), read_text(folder.path() / "whole"));
  }
}

TEST(EncasedRestart, RefusesTheFileOfAnotherCloth)
{
  const TemporaryFolder folder;
  run_in(folder.path(), new_encased_specimen("run 10\nwrite_restart stop\n"));
  const Outcome outcome =
      run_deck(encased_specimen_of("stop", "run 1\n", "strength 60 60 after_strength yield"), 1,
               folder.path());
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.says("remembers plastic strain and damage of 0 facets, this one of "))
      << outcome.output;
}

// The file holds what a rigid sleeve has; its release then finds masses as in the run that went on.
TEST(EncasedRestart, ReleasesASleeveThatWasRigidAsTheRunThatWentOn)
{
  const TemporaryFolder folder;
  const std::string release =
      "fix_modify side rigid no pressure 50e3 ramp 1000\nfix_modify bottom servo 50e3 ramp 1000\n";
  run_in(folder.path(), new_encased_specimen("run 1000\nunfix grow\nrun 500\nwrite_restart stop\n" +
                                             release + rest("whole")));
  run_in(folder.path(), host + "read_restart stop\n" + materials_and_sleeve("rigid yes") + motion +
                            release + rest("parts"));
  EXPECT_EQ(read_text(folder.path() / "parts"), read_text(folder.path() / "whole"));
}

TEST(EncasedRestart, TakesThePressureThatAFixLineNames)
{
  const TemporaryFolder folder;
  run_in(folder.path(), new_encased_specimen(encased_shear + "run 10\nwrite_restart stop\n"));
  const std::string numbers =
      "run 0\nvariable now equal f_side[1]\nprint \"now ${now}\"\n"
      "run 100\nvariable later equal f_side[1]\nprint \"later ${later}\"\n";
  const auto restarted = [&](const std::string& words) {
    return run_deck(host + "read_restart stop\n" + materials_and_sleeve(words) + motion + numbers,
                    1, folder.path());
  };
  const Outcome same = restarted("");
  EXPECT_EQ(same.value("now"), 50e3);
  EXPECT_EQ(same.value("later"), 50e3);
  const Outcome other = restarted("pressure 60e3 ramp 100");
  EXPECT_EQ(other.value("now"), 50e3);
  EXPECT_EQ(other.value("later"), 60e3);
}

TEST(EncasedRestart, RefusesTheFileOfAnotherMesh)
{
  const TemporaryFolder folder;
  run_in(folder.path(), new_encased_specimen("run 10\nwrite_restart stop\n"));
  const std::string deck = encased_specimen_of("stop", "run 1\n");
  const Outcome outcome = run_deck(
      std::string(deck).replace(deck.find("edge 0.006"), 10, "edge 0.008"), 1, folder.path());
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.says("the sleeve of the restart file has 338 nodes, this one "))
      << outcome.output;
}
