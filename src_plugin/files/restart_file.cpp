// SPDX-License-Identifier: GPL-2.0-only
#include "files/restart_file.h"

#include "files/restart_bytes.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

std::string with(std::string name, char placeholder, const std::string& text)
{
  const auto at = name.find(placeholder);
  return at == std::string::npos ? name : name.replace(at, 1, text);
}

/// What the head says about the rest.
struct Head {
  std::int64_t grains = -1;
  int types = -1, blocks = -1;
};

// The head is a list of numbers and names, each behind the number of what it is, ended by a
// negative one. These are the host's numbers for those that are no single int.
enum Entry {
  version = 0,
  units = 4,
  step = 5,
  blocks = 7,
  atom_style = 22,
  grains = 23,
  types = 24,
  bonds = 25,
  angles = 28,
  dihedrals = 31,
  impropers = 34,
  first_double = 37,
  last_double = 51
};
enum TypeEntry { masses = 0 };
enum ForceEntry { pair = 0 };

void take_atom_style(RestartBytes& bytes)
{
  if (bytes.take_name() != "hybrid") return;
  for (auto left = bytes.take_count(5); left > 0; --left) bytes.take_name();
}

Head take_head(RestartBytes& bytes)
{
  Head head;
  if (bytes.take<std::int32_t>() != version) bytes.strange();
  if (bytes.take_name().rfind("Version ", 0) != 0) bytes.strange();
  for (auto entry = bytes.take<std::int32_t>(); entry >= 0; entry = bytes.take<std::int32_t>()) {
    if (entry > last_double) bytes.strange();
    if (entry == units)
      bytes.take_name();
    else if (entry == atom_style)
      take_atom_style(bytes);
    else if (entry == grains)
      head.grains = bytes.take<std::int64_t>();
    else if (entry == step || entry == bonds || entry == angles || entry == dihedrals ||
             entry == impropers || entry >= first_double)
      bytes.skip(8);
    else if (entry == types)
      head.types = bytes.take<std::int32_t>();
    else if (entry == blocks)
      head.blocks = bytes.take<std::int32_t>();
    else
      bytes.skip(4);
  }
  constexpr int most_types = 100000;
  if (head.grains < 0 || head.blocks < 1 || head.types < 1 || head.types > most_types)
    bytes.strange();
  return head;
}

void skip_groups(RestartBytes& bytes)
{
  constexpr int most = 32;
  const auto groups = bytes.take_count(4);
  std::int64_t named = 0;
  for (int n = 0; n < most && named < groups; ++n) {
    const auto length = bytes.take_count(1);
    bytes.skip(length);
    if (length > 0) ++named;
  }
  if (groups < 1 || named < groups) bytes.strange();
}

void skip_masses(RestartBytes& bytes, const Head& head)
{
  for (auto entry = bytes.take<std::int32_t>(); entry >= 0; entry = bytes.take<std::int32_t>()) {
    if (entry != masses) bytes.strange();
    bytes.skip(8L * head.types);
  }
}

/// False where something stands that only its own style can read.
bool skip_force_fields(RestartBytes& bytes, const Head& head)
{
  for (auto entry = bytes.take<std::int32_t>(); entry >= 0; entry = bytes.take<std::int32_t>()) {
    if (entry > 4) bytes.strange();
    const std::string style = bytes.take_name();
    if (entry != pair || style != "gran") return false;
    bytes.skip(8);  // number of the contact model
    bytes.skip(2L * head.types * (head.types + 1L));
  }
  return true;
}

void skip_fixes(RestartBytes& bytes)
{
  for (auto left = bytes.take_count(12); left > 0; --left) {
    bytes.take_name();
    bytes.take_name();
    bytes.skip(bytes.take_count(1));
  }
  for (auto left = bytes.take_count(12); left > 0; --left) {
    bytes.take_name();
    bytes.take_name();
    if (bytes.take<std::int32_t>() < 0) bytes.strange();
  }
}

/// Number of grains in the next block, each of which begins with the number of its numbers.
std::int64_t take_block(RestartBytes& bytes)
{
  constexpr double smallest = 8.0;
  const auto count = bytes.take_count(8);
  const std::vector<double> numbers = bytes.take_numbers(count);
  std::int64_t grains = 0, at = 0;
  for (; at < count; ++grains) {
    const double size = numbers[static_cast<std::size_t>(at)];
    if (!(size >= smallest && size <= static_cast<double>(count - at))) bytes.strange();
    at += static_cast<std::int64_t>(size);
  }
  return grains;
}

}  // namespace

std::string restart_file_of(const std::string& pattern)
{
  const fs::path wanted(pattern);
  const std::string name = with(wanted.filename(), '%', "base");
  const auto star = name.find('*');
  if (star == std::string::npos) return pattern;
  const std::string begin = name.substr(0, star), end = name.substr(star + 1);
  std::string latest;
  std::error_code none;
  const fs::path folder = wanted.has_parent_path() ? wanted.parent_path() : ".";
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string found = entry.path().filename();
    if (found.size() <= begin.size() + end.size() || found.rfind(begin, 0) != 0 ||
        found.compare(found.size() - end.size(), end.size(), end) != 0)
      continue;
    const std::string number = found.substr(begin.size(), found.size() - begin.size() - end.size());
    if (number.find_first_not_of("0123456789") != std::string::npos) continue;
    const auto is_later = [](const std::string& a, const std::string& b) {
      return a.size() != b.size() ? a.size() > b.size() : a > b;
    };
    if (latest.empty() || is_later(number, latest)) latest = number;
  }
  if (latest.empty()) refuse_restart_file(pattern, "for which there is no file");
  return (wanted.parent_path() / with(wanted.filename(), '*', latest)).string();
}

void check_restart_file(const std::string& file)
{
  const bool is_split = file.find('%') != std::string::npos;
  RestartBytes bytes(with(file, '%', "base"));
  // The walk below does not come to the end where a style of another library has written.
  if (seal_found(file) == SealFound::of_other_bytes) bytes.strange();
  const Head head = take_head(bytes);
  skip_groups(bytes);
  skip_masses(bytes, head);
  if (!skip_force_fields(bytes, head)) return;
  skip_fixes(bytes);
  std::int64_t grains = 0;
  for (int n = 0; n < head.blocks; ++n) {
    if (is_split) {
      RestartBytes part(with(file, '%', std::to_string(n)));
      grains += take_block(part);
    } else {
      grains += take_block(bytes);
    }
  }
  if (!is_split) bytes.take_end();
  if (grains != head.grains)
    refuse_restart_file(file, "which holds " + std::to_string(grains) + " of its " +
                                  std::to_string(head.grains) + " grains");
}

}  // namespace encased_column
