// SPDX-License-Identifier: GPL-2.0-only
#include "core/input_error.h"
#include "drawing/parallel_tasks.h"
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

using Tasks = std::vector<std::function<void()>>;

/// Tasks that each write a letter to a file of their own.
Tasks letters(const fs::path& folder, int count)
{
  Tasks tasks;
  for (int i = 0; i < count; ++i)
    tasks.emplace_back([=] { std::ofstream(folder / std::to_string(i), std::ios::app) << 'x'; });
  return tasks;
}

}  // namespace

TEST(ParallelTasks, AreEachDoneOnce)
{
  for (const int processes : {1, 3, 20}) {
    const TemporaryFolder folder;
    do_in_processes(letters(folder.path(), 11), processes);
    for (int i = 0; i < 11; ++i)
      EXPECT_EQ(read_text(folder.path() / std::to_string(i)), "x") << i << " of " << processes;
  }
}

TEST(ParallelTasks, TellTheSentenceOfTheOneThatFails)
{
  Tasks tasks{[] { throw InputError("a folder must be a folder"); }, [] {}};
  try {
    do_in_processes(tasks, 2);
    FAIL() << "no error";
  } catch (const InputError& problem) {
    EXPECT_STREQ(problem.what(), "a folder must be a folder");
  }
}

TEST(ParallelTasks, TellHowAProcessBrokeOff)
{
  const std::pair<Tasks, const char*> cases[] = {
      {{[] { std::_Exit(7); }, [] {}}, "found a drawing process that ended with code 7,"},
      {{[] { raise(SIGKILL); }, [] {}},
       "found a drawing process that broke off by signal 9 (Killed),"}};
  for (const auto& [tasks, said] : cases) try {
      do_in_processes(tasks, 2);
      FAIL() << "no error";
    } catch (const InputError& problem) {
      EXPECT_NE(std::string(problem.what()).find(said), std::string::npos) << problem.what();
    }
}
