// SPDX-License-Identifier: GPL-2.0-only
#include "config/yaml_map.h"

#include "config/units.h"
#include "core/input_error.h"
#include "runner/text_file.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>

namespace encased_column {

namespace {

std::string names_of(const std::vector<ConfigKey>& keys)
{
  std::string names;
  for (const ConfigKey& key : keys) names += (names.empty() ? "" : ", ") + key.name;
  return names;
}

int line_of(const YAML::Node& node)
{
  return node.Mark().line + 1;
}

std::string in_file(const std::string& file, int line)
{
  return "in line " + std::to_string(line) + " of '" + file + "'";
}

}  // namespace

YamlMap::YamlMap(const YAML::Node& node, std::string file, std::string part,
                 const std::vector<ConfigKey>& keys)
    : file_(std::move(file)),
      part_(std::move(part))
{
  if (!node || node.IsNull()) return;
  line_ = line_of(node);
  if (!node.IsMap())
    throw InputError(part_ + " " + in_file(file_, line_) + " takes lines 'key: value', found " +
                     (node.IsScalar() ? "'" + node.Scalar().substr(0, 60) + "'" : "a list") +
                     ", write for example '" + keys.front().name + ": ...'");
  for (const auto& each : node) {
    const std::string key = each.first.IsScalar() ? each.first.Scalar() : "";
    const int line = line_of(each.first);
    if (std::none_of(keys.begin(), keys.end(),
                     [&](const ConfigKey& known) { return known.name == key; }))
      throw InputError("unknown key '" + key + "' of " + part_ + " " + in_file(file_, line) +
                       ", expected one of: " + names_of(keys));
    if (find(key))
      throw InputError("'" + key + "' " + in_file(file_, line) +
                       " must stand once, found it in line " + std::to_string(find(key)->line) +
                       " too, leave one out");
    entries_.push_back({key, std::make_shared<const YAML::Node>(each.second), line});
  }
}

const YamlMap::Entry* YamlMap::find(const std::string& key) const
{
  for (const Entry& one : entries_)
    if (one.key == key) return &one;
  return nullptr;
}

const YamlMap::Entry& YamlMap::needed(const std::string& key) const
{
  if (const Entry* found = find(key)) return *found;
  throw InputError(part_ + " " + in_file(file_, line_) + " must have the key '" + key +
                   "', found none, write '" + key + ": ...'");
}

bool YamlMap::has(const std::string& key) const
{
  return find(key) != nullptr;
}

int YamlMap::line(const std::string& key) const
{
  const Entry* found = find(key);
  return found ? found->line : line_;
}

std::string YamlMap::where() const
{
  return in_file(file_, line_);
}

std::string YamlMap::place(const std::string& key) const
{
  return "'" + key + "' " + in_file(file_, line(key));
}

std::string YamlMap::scalar(const YAML::Node& node, const std::string& key) const
{
  if (node.IsScalar() && !node.Scalar().empty()) return node.Scalar();
  throw InputError("'" + key + "' " + in_file(file_, node.IsNull() ? line(key) : line_of(node)) +
                   " takes one value, found " +
                   (node.IsMap()        ? "a map"
                    : node.IsSequence() ? "a list"
                                        : "nothing") +
                   ", write '" + key + ": VALUE'");
}

std::string YamlMap::text(const std::string& key) const
{
  return scalar(*needed(key).node, key);
}

std::string YamlMap::text(const std::string& key, const std::string& otherwise) const
{
  return has(key) ? text(key) : otherwise;
}

std::string YamlMap::choice(const std::string& key, const std::vector<std::string>& allowed,
                            const std::string& otherwise) const
{
  const std::string word = text(key, otherwise);
  if (std::find(allowed.begin(), allowed.end(), word) != allowed.end()) return word;
  std::string names;
  for (const std::string& one : allowed) names += (names.empty() ? "" : ", ") + one;
  throw InputError(place(key) + " must be one of " + names + ", found '" + word +
                   "', write for example '" + key + ": " + allowed.front() + "'");
}

bool YamlMap::yes(const std::string& key, bool otherwise) const
{
  return choice(key, {"yes", "no"}, otherwise ? "yes" : "no") == "yes";
}

long YamlMap::integer(const std::string& key, long low, long high, long otherwise) const
{
  if (!has(key)) return otherwise;
  const std::string word = text(key);
  const bool whole = word.size() < 10 && word.find_first_not_of("0123456789") == std::string::npos;
  if (whole && std::stol(word) >= low && std::stol(word) <= high) return std::stol(word);
  throw InputError(place(key) + " takes a whole number from " + std::to_string(low) + " to " +
                   std::to_string(high) + ", found '" + word + "', write for example '" + key +
                   ": " + std::to_string(otherwise) + "'");
}

double YamlMap::number_in(const std::string& key, const std::string& unit) const
{
  return read_in_unit(place(key), text(key), unit);
}

std::vector<std::string> YamlMap::texts(const std::string& key) const
{
  const YAML::Node& node = *needed(key).node;
  if (!node.IsSequence()) return {scalar(node, key)};
  std::vector<std::string> all;
  for (const YAML::Node& each : node) all.push_back(scalar(each, key));
  return all;
}

std::vector<std::pair<std::string, std::string>> YamlMap::pairs(const std::string& key) const
{
  std::vector<std::pair<std::string, std::string>> all;
  if (!has(key)) return all;
  const YAML::Node& node = *needed(key).node;
  if (!node.IsMap())
    throw InputError(place(key) + " takes lines 'NAME: VALUE' below it, found something else, " +
                     "write for example '" + key + ": {sigma3: 50e3}'");
  for (const auto& each : node)
    all.emplace_back(scalar(each.first, key), scalar(each.second, each.first.Scalar()));
  return all;
}

YamlMap YamlMap::map(const std::string& key, const std::vector<ConfigKey>& keys) const
{
  const Entry* found = find(key);
  YamlMap below(found ? *found->node : YAML::Node(), file_, "'" + key + "'", keys);
  if (!found) below.line_ = line_;
  return below;
}

std::vector<YamlMap> YamlMap::maps(const std::string& key, const std::string& part,
                                   const std::vector<ConfigKey>& keys) const
{
  const YAML::Node& node = *needed(key).node;
  if (!node.IsSequence() || node.size() == 0)
    throw InputError(place(key) + " takes a list with one line '- ...' at least, found " +
                     (node.IsSequence() ? "none" : "something else") + ", write for example '- {" +
                     keys.front().name + ": ...}'");
  std::vector<YamlMap> all;
  for (const YAML::Node& each : node) {
    all.emplace_back(each, file_, part, keys);
    if (each.IsNull()) all.back().line_ = line(key);
  }
  return all;
}

YamlMap read_yaml(const std::string& path, const std::vector<ConfigKey>& keys)
{
  const std::string text = read_text_file(path, "'" + path + "'");
  try {
    const YAML::Node top = YAML::Load(text);
    return {top, path, "a calibration", keys};
  } catch (const YAML::Exception& problem) {
    const int line = problem.mark.is_null() ? 1 : problem.mark.line + 1;
    throw InputError("'" + path + "' must be YAML, found '" + problem.msg + "' in line " +
                     std::to_string(line) + ", compare with calibration/plain_triaxial.yaml");
  }
}

}  // namespace encased_column
