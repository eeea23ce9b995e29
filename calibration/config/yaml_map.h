// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace YAML {
class Node;
}

namespace encased_column {

/// A key of a configuration file, as the user page lists it.
struct ConfigKey {
  std::string name, meaning;
};

/// A map of a YAML file whose keys are all known. Every accessor throws InputError that names file
/// and line: one sentence with the key, the rule, what was found and what to write.
class YamlMap {
 public:
  /// `node` must be a map with keys of `keys` only, each once. `part` is what messages call it
  /// ("a target").
  YamlMap(const YAML::Node& node, std::string file, std::string part,
          const std::vector<ConfigKey>& keys);

  bool has(const std::string& key) const;
  /// "'value' in line 12 of 'a.yaml'"; of the map itself where it has no such key.
  std::string place(const std::string& key) const;
  std::string where() const;  ///< "in line 12 of 'a.yaml'", of the map itself
  int line(const std::string& key) const;

  std::string text(const std::string& key) const;
  std::string text(const std::string& key, const std::string& otherwise) const;
  /// The text, which must be one of `allowed`.
  std::string choice(const std::string& key, const std::vector<std::string>& allowed,
                     const std::string& otherwise) const;
  bool yes(const std::string& key, bool otherwise) const;
  long integer(const std::string& key, long low, long high, long otherwise) const;
  double number_in(const std::string& key, const std::string& unit) const;
  /// Several texts, or one.
  std::vector<std::string> texts(const std::string& key) const;
  /// Names and values of a map below `key`, in order; empty without it.
  std::vector<std::pair<std::string, std::string>> pairs(const std::string& key) const;
  /// The map below `key`, an empty one where there is none; the maps of a list, one at least.
  YamlMap map(const std::string& key, const std::vector<ConfigKey>& keys) const;
  std::vector<YamlMap> maps(const std::string& key, const std::string& part,
                            const std::vector<ConfigKey>& keys) const;

 private:
  struct Entry {
    std::string key;
    std::shared_ptr<const YAML::Node> node;
    int line;
  };
  const Entry* find(const std::string& key) const;
  const Entry& needed(const std::string& key) const;
  std::string scalar(const YAML::Node& node, const std::string& key) const;

  std::string file_, part_;
  int line_ = 1;
  std::vector<Entry> entries_;
};

/// The top of the file `path`.
YamlMap read_yaml(const std::string& path, const std::vector<ConfigKey>& keys);

}  // namespace encased_column
