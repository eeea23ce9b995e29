#include "runner/descendants.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

struct Stat {
  pid_t parent = 0;
  unsigned long long began = 0;
};

/// The name of a program stands in brackets and may hold brackets and blanks itself.
bool read_stat(const fs::path& folder, Stat& stat)
{
  std::ifstream file(folder / "stat");
  std::string line;
  if (!std::getline(file, line)) return false;
  const std::size_t behind_name = line.rfind(')');
  if (behind_name == std::string::npos) return false;
  std::istringstream words(line.substr(behind_name + 1));
  std::string word;
  for (int field = 3; words >> word; ++field) {
    if (field == 4) stat.parent = static_cast<pid_t>(std::strtol(word.c_str(), nullptr, 10));
    if (field == 22) stat.began = std::strtoull(word.c_str(), nullptr, 10);
  }
  return stat.began > 0;
}

}  // namespace

std::vector<Process> process_tree(pid_t root)
{
  std::multimap<pid_t, Process> children;
  std::vector<Process> tree;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator("/proc", failure)) {
    const pid_t pid = static_cast<pid_t>(std::atol(entry.path().filename().c_str()));
    Stat stat;
    if (pid <= 0 || !read_stat(entry.path(), stat)) continue;
    if (pid == root) tree.push_back({pid, stat.began});
    children.insert({stat.parent, {pid, stat.began}});
  }
  for (std::size_t n = 0; n < tree.size(); ++n) {
    const auto range = children.equal_range(tree[n].pid);
    for (auto child = range.first; child != range.second; ++child) tree.push_back(child->second);
  }
  return tree;
}

std::vector<Process> running(const std::vector<Process>& processes, const fs::path& program)
{
  std::vector<Process> found;
  for (const Process& process : processes) {
    std::error_code failure;
    const fs::path way = fs::path("/proc") / std::to_string(process.pid) / "exe";
    if (fs::equivalent(way, program, failure) && !failure) found.push_back(process);
  }
  return found;
}

}  // namespace encased_column
