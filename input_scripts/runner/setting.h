#pragma once

#include <string>
#include <utility>
#include <vector>

namespace encased_column {

/// Variables and their values as they were written, in order.
using Setting = std::pair<std::string, std::string>;
using Settings = std::vector<Setting>;

/// Reads NAME=VALUE without blanks. Throws InputError, with `keyword` as its subject.
Setting read_setting(const std::string& keyword, const std::string& text);

/// True for a word of letters, digits, '_', '-' and '.' that begins with none of the last two: it
/// can name a folder and stays where it is put.
bool is_folder_name(const std::string& word);

}  // namespace encased_column
