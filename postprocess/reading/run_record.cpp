// SPDX-License-Identifier: GPL-2.0-only
#include "reading/run_record.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>

namespace encased_column {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const fs::path& file)
{
  std::vector<std::string> lines;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    line.erase(line.find_last_not_of(" \t\r") + 1);
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

/// log.liggghts is the last one; log.N.liggghts are those of starts before it.
std::set<fs::path> logs_of(const fs::path& folder)
{
  std::set<fs::path> logs;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (name.rfind("log.", 0) == 0 && entry.path().extension() == ".liggghts")
      logs.insert(entry.path());
  }
  return logs;
}

void read_log(const fs::path& log, RunRecord& record)
{
  // The host adds the place in its source.
  static const std::regex warning(R"(^WARNING[^:]*: (.*?)( \([^()]*:\d+\))?$)");
  static const std::regex loop(R"(^Loop time of (\S+) on .*)");
  std::smatch found;
  for (const std::string& line : lines_of(log)) {
    if (std::regex_match(line, found, warning)) {
      const std::string text = found[1];
      std::vector<std::string>& known = record.warnings;
      if (std::find(known.begin(), known.end(), text) == known.end()) known.push_back(text);
    } else if (std::regex_match(line, found, loop))
      record.loop_time += std::stod(found[1]);
  }
}

}  // namespace

RunRecord read_run_record(const fs::path& folder)
{
  RunRecord record;
  for (const fs::path& log : logs_of(folder)) read_log(log, record);
  static const std::regex wall_time(R"(^wall time (\d+) s$)");
  std::smatch found;
  for (const std::string& line : lines_of(folder / "finished"))
    if (std::regex_match(line, found, wall_time))
      record.wall_time = std::stol(found[1]);
    else
      record.finished = line;
  record.versions = lines_of(folder / "versions.txt");
  record.commands = lines_of(folder / "command.txt");
  return record;
}

}  // namespace encased_column
