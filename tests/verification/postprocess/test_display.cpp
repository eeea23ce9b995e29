// SPDX-License-Identifier: GPL-2.0-only
// The display that provide_display() makes, used as drawing processes use it. Oracle: the X library
// itself, which opens the display or does not.
#include "drawing/display.h"
#include "drawing/parallel_tasks.h"

#include <dlfcn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

using namespace encased_column;

namespace {

// Two drawing processes that open and close the display again and again, so that it often has no
// client at all; ends with code 1 where it was once turned away.
void open_again_and_again()
{
  void* const library = dlopen("libX11.so.6", RTLD_NOW);
  if (!library) std::_Exit(2);
  const auto open = reinterpret_cast<void* (*)(const char*)>(dlsym(library, "XOpenDisplay"));
  const auto close = reinterpret_cast<int (*)(void*)>(dlsym(library, "XCloseDisplay"));
  for (int i = 0; i < 200; ++i) {
    void* const display = open(nullptr);
    if (!display) std::_Exit(1);
    close(display);
    usleep(i % 7 * 500U);
  }
}

}  // namespace

// Started by the test below, under the display.
TEST(Display, DISABLED_Client)
{
  do_in_processes({open_again_and_again, open_again_and_again}, 2);
}

TEST(Display, TurnsNoClientAway)
{
  const pid_t child = fork();
  if (child == 0) {
    unsetenv("DISPLAY");
    provide_display({"--gtest_also_run_disabled_tests", "--gtest_filter=Display.DISABLED_Client"});
    std::_Exit(3);  // not reached: the program has been started anew
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}
