// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/display.h"

#include "core/input_error.h"
#include "runner/processes.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace encased_column {

namespace {

bool has_display()
{
  const char* display = std::getenv("DISPLAY");
  return display && *display;
}

/// Whether the X server that DISPLAY names answers; by the library that VTK brings.
bool display_opens()
{
  void* const library = dlopen("libX11.so.6", RTLD_NOW);
  if (!library) return false;
  using Open = void* (*)(const char*);
  using Close = int (*)(void*);
  const auto open = reinterpret_cast<Open>(dlsym(library, "XOpenDisplay"));
  const auto close = reinterpret_cast<Close>(dlsym(library, "XCloseDisplay"));
  void* const display = open && close ? open(nullptr) : nullptr;
  if (display) close(display);
  return display != nullptr;
}

/// The command that gives what stands behind it a display. `-a` takes the next free number but does
/// not reserve it: two that begin to look at the same one may both take it, so each begins
/// elsewhere. `-noreset`: a server left by its last client starts anew, and meanwhile turns away
/// the drawing process that comes next.
std::vector<std::string> xvfb_run()
{
  constexpr int first = 100, numbers = 10000;
  return {"xvfb-run", "-a",
          "-n",       std::to_string(first + getpid() % numbers),
          "-s",       "-screen 0 1280x1024x24 -nolisten tcp -noreset"};
}

}  // namespace

std::string display_problem()
{
  if (has_display())
    return display_opens() ? ""
                           : "pictures take the display that DISPLAY names, found that '" +
                                 std::string(std::getenv("DISPLAY")) +
                                 "' cannot be opened, write 'unset DISPLAY' to draw without one";
  std::vector<std::string> words = xvfb_run();
  words.push_back("true");
  const Answer answer = answer_of(words);
  if (answer.code == 0) return "";
  const std::string found =
      answer.code == 127 ? "neither"
                         : "that xvfb-run fails: '" +
                               answer.text.substr(0, answer.text.find_last_not_of('\n') + 1) + "'";
  return "pictures take a display or the program xvfb-run, found " + found +
         ", write 'apt-get install xvfb xauth', or '--no-pictures' for the tables alone";
}

void provide_display(const std::vector<std::string>& arguments)
{
  if (has_display()) return;

  // The path the kernel knows: the name this was called by may have been found along PATH.
  std::vector<std::string> words = xvfb_run();
  words.push_back(std::filesystem::read_symlink("/proc/self/exe").string());
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execvp(pointers[0], pointers.data());
  throw InputError(
      "pictures take a display or the program xvfb-run, found neither (" +
      std::string(std::strerror(errno)) +
      "), write 'apt-get install xvfb xauth', or '--no-pictures' for the tables alone");
}

}  // namespace encased_column
