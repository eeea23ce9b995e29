#include "reading/deck_inputs.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>

namespace encased_column {

namespace {

namespace fs = std::filesystem;

/// What stands behind `variable NAME index VALUE #` in the deck files of `folder`.
std::map<std::string, std::string> comments_of(const fs::path& folder)
{
  static const std::regex line_with_comment(R"(^variable\s+(\w+)\s+index\s+\S+\s*#\s*(.*))");
  std::map<std::string, std::string> comments;
  if (!fs::is_directory(folder)) return comments;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".lmp") continue;
    std::ifstream deck(entry.path());
    std::smatch found;
    for (std::string line; std::getline(deck, line);)
      if (std::regex_match(line, found, line_with_comment)) comments[found[1]] = found[2];
  }
  return comments;
}

/// Takes the unit in brackets that a comment begins with off it.
std::string take_unit(std::string& comment)
{
  static const std::regex unit_and_meaning(R"(\[([^\]]+)\]\s*(.*))");
  std::smatch found;
  if (!std::regex_match(comment, found, unit_and_meaning)) return "-";
  const std::string unit = found[1];
  comment = found.str(2);
  return unit;
}

/// `value` with each ${name} in it replaced by that variable.
std::string resolved(std::string value, const CaseRun& run)
{
  std::smatch found;
  static const std::regex reference(R"(\$\{(\w+)\})");
  if (!std::regex_search(value, found, reference)) return value;
  const std::string name = found[1];
  for (const auto& [other, its_value] : run.inputs)
    if (other == name && its_value.find("${") == std::string::npos)
      return value.replace(static_cast<std::size_t>(found.position()),
                           static_cast<std::size_t>(found.length()), its_value);
  return value;
}

}  // namespace

std::vector<DeckInput> deck_inputs(const CaseRun& run)
{
  std::map<std::string, std::string> comments = comments_of(run.folder / "input");
  std::vector<DeckInput> inputs;
  for (const auto& [name, value] : run.inputs) {
    std::string meaning = comments[name];
    const std::string unit = take_unit(meaning);
    inputs.push_back({name, resolved(value, run), unit, meaning.empty() ? "-" : meaning});
  }
  return inputs;
}

}  // namespace encased_column
