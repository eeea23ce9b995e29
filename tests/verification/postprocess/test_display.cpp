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

// The test starts its own program anew, as the client under the display.
TEST(Display, TurnsNoClientAway)
{
  constexpr const char* client = "ENCASE_TEST_IS_CLIENT";
  if (std::getenv(client)) return do_in_processes({open_again_and_again, open_again_and_again}, 2);
  const pid_t child = fork();
  if (child == 0) {
    setenv(client, "yes", 1);
    unsetenv("DISPLAY");
    provide_display({"--gtest_filter=Display.TurnsNoClientAway"});
    std::_Exit(3);  // not reached: the program has been started anew
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}
