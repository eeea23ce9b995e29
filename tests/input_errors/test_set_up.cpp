// SPDX-License-Identifier: GPL-2.0-only
// The command input_scripts/set_up says what it does, and only when it does it: tried on a small
// project. And CMake looks for LIGGGHTS where it is told to.
#include "support/child_program.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <regex>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const fs::path source = ENCASE_SOURCE;

/// A project with the command and two targets, each of which copies a file.
class SetUp : public testing::Test {
 protected:
  SetUp()
  {
    fs::create_directories(root_ / "input_scripts");
    fs::copy(source / "input_scripts/set_up", root_ / "input_scripts");
    write("input_scripts/packages.txt", "");
    write("one.in", "");
    write("two.in", "");
    write("CMakeLists.txt", R"(
cmake_minimum_required(VERSION 3.25)
project(small LANGUAGES NONE)
file(GLOB inputs CONFIGURE_DEPENDS *.in)
foreach(name one two)
  add_custom_command(OUTPUT ${name} DEPENDS ${CMAKE_SOURCE_DIR}/${name}.in
    COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_SOURCE_DIR}/${name}.in ${name})
  add_custom_target(make_${name} ALL DEPENDS ${name})
endforeach()
message(STATUS "chosen ${CHOICE}")
if(CHOICE STREQUAL broken)
  message(FATAL_ERROR "no such choice")
endif()
)");
  }

  void write(const std::string& file, const std::string& text) const
  {
    std::ofstream(root_ / file) << text;
  }

  Outcome set_up(const std::vector<std::string>& options = {},
                 const std::string& targets = "") const
  {
    std::vector<std::string> words{"env", "ENCASE_TARGETS=" + targets,
                                   root_ / "input_scripts/set_up"};
    words.insert(words.end(), options.begin(), options.end());
    return run_program(words, root_);
  }

  std::string build() const { return root_ / "build"; }
  std::string building() const
  {
    return "Building " + build() + " (the first time takes some minutes)\n";
  }
  std::string configuring() const { return "Configuring " + build() + "\n"; }

  TemporaryFolder folder_;
  const fs::path root_ = folder_.path();
};

/// What CMake says to a project that looks for LIGGGHTS with `option`, on one line.
std::string search_for_liggghts(const std::string& option)
{
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "CMakeLists.txt")
      << "cmake_minimum_required(VERSION 3.25)\nproject(search LANGUAGES NONE)\n"
      << "list(APPEND CMAKE_MODULE_PATH " << source / "cmake"
      << ")\n"
      << "find_package(LIGGGHTS 3.8 REQUIRED)\n";
  const Outcome outcome =
      run_program({"cmake", "-S", ".", "-B", "build", "-G", "Ninja", option}, folder.path());
  EXPECT_NE(outcome.exit_code, 0);
  return std::regex_replace(outcome.output, std::regex("\\s+"), " ");
}

}  // namespace

TEST_F(SetUp, LeavesOptionalPackagesOut)
{
  write("input_scripts/packages.txt",
        "no-such-package-17  optional: of nothing\nno-such-package-18  tests: nothing\n");
  const Outcome outcome = run_program(
      {"env", "-u", "ENCASE_OPTIONAL", "-u", "ENCASE_TESTING", root_ / "input_scripts/set_up"},
      root_);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.output, configuring() + building());
}

TEST_F(SetUp, SaysThatItBuildsWhereOtherTargetsWereBuiltBefore)
{
  EXPECT_EQ(set_up({}, "make_one").output, configuring() + building());
  EXPECT_EQ(set_up().output, building());
  EXPECT_TRUE(fs::exists(root_ / "build/two"));
}

TEST_F(SetUp, IsQuietWhenNothingIsToBeDone)
{
  set_up();
  EXPECT_EQ(set_up().output, "");
  EXPECT_EQ(set_up({}, "make_one make_two").output, "");
}

TEST_F(SetUp, BuildsWhatIsOlderThanItsSource)
{
  set_up();
  write("two.in", "changed");
  EXPECT_EQ(set_up({}, "make_one").output, "");
  EXPECT_EQ(set_up().output, building());
  EXPECT_EQ(read_text(root_ / "build/two"), "changed");
}

TEST_F(SetUp, ConfiguresAgainWhenOptionsAreGiven)
{
  set_up();
  EXPECT_EQ(set_up({"-DCHOICE=other"}).output, configuring());
  const std::string cache = read_text(root_ / "build/CMakeCache.txt");
  EXPECT_NE(cache.find("CHOICE:UNINITIALIZED=other"), std::string::npos);
  EXPECT_EQ(set_up({build(), "-DCHOICE=third"}).output, configuring());
}

TEST_F(SetUp, ShowsTheEndOfTheLogOfWhatFailed)
{
  const Outcome configured = set_up({"-DCHOICE=broken"});
  EXPECT_EQ(configured.exit_code, 1);
  EXPECT_TRUE(configured.says("no such choice")) << configured.output;
  EXPECT_TRUE(configured.says("-DCHOICE=broken' failed, the end of its log is above\n"));

  const Outcome built = set_up({"-DCHOICE="}, "make_three");
  EXPECT_EQ(built.exit_code, 1);
  EXPECT_TRUE(built.says("unknown target 'make_three'")) << built.output;
  EXPECT_TRUE(built.says("--target make_three' failed, the end of its log is above\n"));
}

// Programs that stand for apt-get and dpkg-query; the screen is a terminal, which `script` makes.
TEST_F(SetUp, TellsHowFarThePackagesAre)
{
  if (geteuid() != 0) GTEST_SKIP() << "only root is not asked for sudo";
  write("input_scripts/packages.txt", "lacking   for a reason\n");
  fs::create_directory(root_ / "stand_in");
  write("stand_in/dpkg-query", "#!/bin/sh\nexit 1\n");
  write("stand_in/apt-get",
        "#!/bin/sh\n[ \"$1\" = update ] && exit\necho Reading lists\n"
        "echo dlstatus:1:25.5:Retrieving\necho pmstatus:lacking:60:Unpacking\n"
        "[ -z \"$BROKEN\" ] || { echo no space left; exit 100; }\n");
  for (const char* name : {"dpkg-query", "apt-get"})
    fs::permissions(root_ / "stand_in" / name, fs::perms::owner_all);
  const auto installed = [&](const std::string& setting) {
    return run_program(
        {"env", setting, "PATH=" + (root_ / "stand_in").string() + ":" + getenv("PATH"), "script",
         "-qec", root_ / "input_scripts/set_up", "/dev/null"},
        root_);
  };
  const Outcome good = installed("BROKEN=");
  EXPECT_EQ(good.exit_code, 0) << good.output;
  EXPECT_TRUE(good.says("Installing 1 missing packages: lacking\r\n")) << good.output;
  EXPECT_TRUE(
      good.says("\r\x1b[K25 % of the packages fetched\r\x1b[K60 % of the packages installed"))
      << good.output;
  const Outcome bad = installed("BROKEN=yes");
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_TRUE(bad.says("no space left")) << bad.output;
  EXPECT_TRUE(bad.says("lacking' failed, the end of its log is above")) << bad.output;
}

TEST(FindLiggghts, RefusesARootWithoutIt)
{
  const std::string said = search_for_liggghts("-DLIGGGHTS_ROOT=/etc");
  EXPECT_NE(
      said.find("LIGGGHTS_ROOT must name a folder with a built LIGGGHTS, found no "
                "src/pair_gran_base.h or include/liggghts/pair_gran_base.h and no "
                "libliggghts.so or liblmp_auto.so in lib/, src/ or src-build/ in '/etc', give "
                "-DLIGGGHTS_ROOT=DIR, or -DLIGGGHTS_ROOT= for Debian's package."),
      std::string::npos)
      << said;
}
