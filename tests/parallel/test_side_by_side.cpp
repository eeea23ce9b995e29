// SPDX-License-Identifier: GPL-2.0-only
// Programs started alone, many of them at the same time.
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace encased_column::testing;

// Open MPI would give them one folder together, which the first to end removes while another
// begins. Here that folder cannot be made, as there is a file of its name.
TEST(SideBySide, AProgramAloneNeedsNoFolderThatItWouldShareWithOthers)
{
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "file") << "no folder\n";
  std::ofstream(folder.path() / "in.lmp") << "print \"at work\"\n";
  for (const char* isolated : {"0", "1"}) {
    const Outcome outcome =
        run_program({"env", "OMPI_MCA_orte_tmpdir_base=" + (folder.path() / "file/folder").string(),
                     std::string("OMPI_MCA_ess_singleton_isolated=") + isolated, ENCASE_PROGRAM,
                     "-in", "in.lmp"},
                    folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_TRUE(outcome.says("at work")) << outcome.output;
  }
}
