#pragma once

#include "runner/setting.h"

#include <filesystem>
#include <string>

namespace encased_column {

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
