// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace encased_column {

/// Variables and their values as they were written, in order.
using Setting = std::pair<std::string, std::string>;
using Settings = std::vector<Setting>;

/// The value of `name`; nullptr where there is none.
const std::string* value_in(const Settings& settings, const std::string& name);

/// Reads NAME=VALUE without blanks. Throws InputError, with `keyword` as its subject.
Setting read_setting(const std::string& keyword, const std::string& text);

/// True for a word of letters, digits, '_', '-' and '.' that begins with none of the last two: it
/// can name a folder and stays where it is put.
bool is_folder_name(const std::string& word);

/// What the case.json of a run folder says: which case this is, what was asked for, and what the
/// run itself says it used.
struct CaseRecord {
  std::string id, deck, title, reproduces;
  Settings asked;
  Settings used;  ///< empty as long as the run has not said
};

/// The one reader of case.json. Throws InputError with one sentence for a file that is none.
CaseRecord read_case_record(const std::filesystem::path& file);

void write_case_record(const std::filesystem::path& file, const CaseRecord& record);

}  // namespace encased_column
