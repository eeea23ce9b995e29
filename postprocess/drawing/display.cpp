#include "drawing/display.h"

#include "core/input_error.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace encased_column {

void provide_display(const std::vector<std::string>& arguments)
{
  const char* display = std::getenv("DISPLAY");
  if (display && *display) return;

  // The path the kernel knows: the name this was called by may have been found along PATH.
  std::vector<std::string> words{"xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -nolisten tcp",
                                 std::filesystem::read_symlink("/proc/self/exe").string()};
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
