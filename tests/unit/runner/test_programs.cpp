// SPDX-License-Identifier: GPL-2.0-only
// Programs that run at the same time do not come into each other's way.
#include "core/input_error.h"
#include "runner/machine_speed.h"
#include "runner/passing_folder.h"
#include "runner/processes.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

using namespace encased_column;
namespace fs = std::filesystem;

namespace {

fs::path write_script(const fs::path& folder, const std::string& lines)
{
  const fs::path script = folder / "program";
  std::ofstream(script) << "#!/bin/sh\n" << lines;
  fs::permissions(script, fs::perms::owner_all);
  return script;
}

}  // namespace

TEST(Programs, HaveTheFolderOfOpenMpiTheyAreGiven)
{
  const PassingFolder folder("a test");
  for (const char* own : {"first", "second"}) {
    const fs::path screen = folder.path() / own;
    const pid_t pid = start_program({{"sh", "-c", "env | grep OMPI_MCA_orte_tmpdir_base"},
                                     "",
                                     screen,
                                     false,
                                     -1,
                                     folder.path() / "at" / own});
    for (int code = 0; !has_ended(pid, code);)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(encased_column::testing::read_text(screen),
              "OMPI_MCA_orte_tmpdir_base=" + (folder.path() / "at" / own).string() + "\n");
  }
}

TEST(PassingFolder, IsAnotherOneEachTimeAndGoesWithAllInIt)
{
  fs::path first_path;
  {
    const PassingFolder first("a test"), second("a test");
    first_path = first.path();
    EXPECT_NE(first.path(), second.path());
    fs::create_directories(first.path() / "a/b");
  }
  EXPECT_FALSE(fs::exists(first_path));
}

TEST(MachineSpeed, TellsWhatTheProgramSaidThatDidNotRunToItsEnd)
{
  const PassingFolder folder("a test");
  Places places;
  places.inputs = folder.path();
  places.host = write_script(folder.path(), "echo ERROR: no room for grains\nexit 1\n");
  try {
    measure_machine(places, 2);
    FAIL() << "a speed was measured";
  } catch (const InputError& problem) {
    EXPECT_NE(std::string(problem.what()).find("ERROR: no room for grains\n"), std::string::npos)
        << problem.what();
  }
}
