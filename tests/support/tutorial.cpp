// SPDX-License-Identifier: GPL-2.0-only
#include "support/tutorial.h"

#include "support/child_program.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace encased_column::testing {

namespace fs = std::filesystem;

namespace {

const std::string fence = "```";

/// Number of '#' of a heading, 0 for any other line.
std::size_t rank_of(const std::string& line)
{
  const std::size_t rank = line.find_first_not_of('#');
  return rank != std::string::npos && line[rank] == ' ' ? rank : 0;
}

TutorialStep step_of(const std::string& head, int line)
{
  TutorialStep step;
  step.line = line;
  std::istringstream words(head);
  words >> step.kind;
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    step.words[word.substr(0, equals)] = equals == std::string::npos ? "" : word.substr(equals + 1);
  }
  return step;
}

/// The shell of the reader: each call goes on in the folder and with the variables of the last.
class Shell {
 public:
  Shell(const fs::path& home, const fs::path& from) : home_(home)
  {
    std::ofstream(state()) << "unset ENCASE_SOURCE\nexport HOME='" << home.string() << "'\ncd '"
                           << from.string() << "'\n";
  }
  ~Shell()
  {
    std::error_code ignored;
    fs::remove(state(), ignored);
  }
  Shell(const Shell&) = delete;
  Shell& operator=(const Shell&) = delete;

  Outcome run(const std::string& commands) const
  {
    const std::string keep = "{ export -p; echo \"cd '$PWD'\"; } >'" + state().string() + "'";
    return run_program(
        {"bash", "-c",
         "set -e -o pipefail\n. '" + state().string() + "'\n" + commands + "\n" + keep},
        home_);
  }
  fs::path folder() const
  {
    std::string last;
    std::ifstream stream(state());
    for (std::string line; std::getline(stream, line);)
      if (line.rfind("cd '", 0) == 0) last = line.substr(4, line.size() - 5);
    return last;
  }

 private:
  fs::path state() const { return home_ / ".shell_of_the_reader"; }
  fs::path home_;
};

bool is_there(const std::string& name, const Shell& shell)
{
  return shell.run("command -v " + name + " || python3 -c 'import " + name + "'").exit_code == 0;
}

/// The first line of `wanted` that `lines` do not hold in their order; empty when all are there.
std::string missing_line(const std::string& wanted, const std::vector<std::string>& lines)
{
  std::size_t at = 0;
  std::istringstream stream(wanted);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos) continue;
    line = line.substr(first, line.find_last_not_of(' ') + 1 - first);
    while (at < lines.size() && !is_like(lines[at], line)) ++at;
    if (at++ == lines.size()) return line;
  }
  return "";
}

std::string end_of(const std::string& text)
{
  return text.size() > 3000 ? "..." + text.substr(text.size() - 3000) : text;
}

std::vector<std::string> lines_in(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// `old` with a block of `changes`. Throws std::runtime_error for a line that is not there.
std::string changed(const std::string& old, const std::string& changes)
{
  std::vector<std::string> lines = lines_in(old);
  auto place = lines.begin();
  for (const std::string& change : lines_in(changes)) {
    if (change.empty()) continue;
    const std::string line = change.substr(1);
    if (change.front() == '+') {
      place = lines.insert(place, line) + 1;
      continue;
    }
    place = std::find(lines.begin(), lines.end(), line);
    if (place == lines.end()) throw std::runtime_error("there is no line '" + line + "'");
    place = lines.erase(place);
  }
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace

bool is_like(const std::string& line, const std::string& pattern)
{
  const std::size_t dots = pattern.find("...");
  if (dots == std::string::npos) return line == pattern;
  if (line.compare(0, dots, pattern, 0, dots) != 0) return false;
  const std::string rest = pattern.substr(dots + 3);
  for (std::size_t from = dots; from <= line.size(); ++from)
    if (is_like(line.substr(from), rest)) return true;
  return false;
}

std::vector<TutorialStep> read_steps(const fs::path& page, const std::string& section)
{
  std::ifstream stream(page);
  int number = 0;
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error(page.string() + ":" + std::to_string(number) + ": " + why);
  };
  if (!stream) refuse("cannot be read");
  std::vector<TutorialStep> steps;
  std::size_t inside = section.empty() ? 1 : 0;  // rank of the section's heading
  bool found = section.empty();
  for (std::string line; std::getline(stream, line);) {
    ++number;
    const std::size_t rank = rank_of(line);
    if (!section.empty() && rank > 0) {
      if (inside > 0 && rank <= inside) inside = 0;
      if (line.substr(rank + 1) == section) {
        inside = rank;
        found = true;
      }
    }
    if (line.rfind(fence, 0) != 0) continue;
    TutorialStep step = step_of(line.substr(fence.size()), number);
    bool ends = false;
    while (!ends && std::getline(stream, line)) {
      ++number;
      ends = line == fence;
      if (!ends) step.text += line + "\n";
    }
    if (!ends) refuse("a block does not end");
    if (inside > 0) steps.push_back(step);
  }
  if (!found) refuse("no heading '" + section + "'");
  return steps;
}

std::string follow(const std::vector<TutorialStep>& steps, const fs::path& home,
                   const fs::path& from)
{
  const Shell shell(home, from);
  std::map<fs::path, bool> begun;  // files of the page
  Outcome last{0, ""};
  bool left_out = false;  // the commands before
  for (const TutorialStep& step : steps) {
    const std::string where = "line " + std::to_string(step.line) + ": ";
    if (step.kind == "output") {
      if (left_out) continue;
      const std::string missing = missing_line(step.text, last.lines());
      if (!missing.empty())
        return where + "'" + missing + "' is not in its place in\n" + end_of(last.output);
      continue;
    }
    const auto needs = step.words.find("needs");
    left_out = step.words.count("by_hand") ||
               (needs != step.words.end() && !is_there(needs->second, shell));
    if (left_out) continue;
    const auto name = step.words.find("file");
    if (name != step.words.end()) {
      const fs::path file = shell.folder() / name->second;
      std::ofstream stream(file, begun[file] ? std::ios::app : std::ios::trunc);
      const auto old = step.words.find("from");
      try {
        stream << (old == step.words.end()
                       ? step.text
                       : changed(read_text(shell.folder() / old->second), step.text));
      } catch (const std::runtime_error& problem) {
        return where + problem.what();
      }
      begun[file] = true;
      if (!stream.flush()) return where + "cannot write " + file.string();
    } else if (step.kind == "sh") {
      last = shell.run(step.text);
      if (last.exit_code != 0)
        return where + "exit code " + std::to_string(last.exit_code) + " and\n" +
               end_of(last.output);
    }
  }
  return "";
}

fs::path clone_in(const fs::path& home)
{
  // As the run command and the pages do: root may start MPI, ranks that wait let others work.
  setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
  setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  setenv("OMPI_MCA_mpi_yield_when_idle", "1", 1);
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 1);
  const fs::path clone = home / "encased-columns";
  fs::create_directories(clone);
  fs::create_directory_symlink(fs::path(ENCASE_PROGRAM).parent_path().parent_path(),
                               clone / "build");
  fs::create_directory_symlink(fs::path(ENCASE_SOURCE) / "input_scripts", clone / "input_scripts");
  return clone;
}

}  // namespace encased_column::testing
