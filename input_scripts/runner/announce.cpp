#include "runner/announce.h"

#include "core/input_error.h"
#include "runner/child_process.h"

#include <sys/utsname.h>

#include <fstream>
#include <sstream>

namespace encased_column {

std::string stopped_line(const Left& left)
{
  std::string line = "Stopped";
  if (!left.resumable.empty()) {
    line += "; --resume goes on with";
    for (std::size_t n = 0; n < left.resumable.size(); ++n)
      line += (n ? ", " : " ") + left.resumable[n].first + " from stage " +
              std::to_string(left.resumable[n].second);
  }
  if (!left.begin_again.empty()) {
    line += left.resumable.empty() ? "; --resume begins again with" : ", and begins again with";
    for (std::size_t n = 0; n < left.begin_again.size(); ++n)
      line += (n ? ", " : " ") + left.begin_again[n];
  }
  if (left.resumable.empty() && left.begin_again.empty() && left.tables_missing)
    line += "; all cases have ended, --resume makes their tables";
  return line;
}

std::string versions_text(const std::string& of_project, int cores, int ranks,
                          const std::string& packages_file)
{
  utsname machine{};
  uname(&machine);
  std::string text = "encased columns " + of_project + "\ncores " + std::to_string(cores) +
                     ", ranks " + std::to_string(ranks) + ", " + machine.sysname + " " +
                     machine.release + " " + machine.machine + "\n";
  std::vector<std::string> query{"dpkg-query", "-W", "-f", "${Package} ${Version}\n"};
  std::ifstream packages(packages_file);
  for (std::string line; std::getline(packages, line);) {
    std::istringstream words(line);
    std::string name;
    if (words >> name && name.front() != '#') query.push_back(name);
  }
  return text + (query.size() > 4 ? output_of(query) : "");
}

}  // namespace encased_column
