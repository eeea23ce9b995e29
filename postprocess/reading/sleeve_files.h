#pragma once

#include "analysis/sleeve_checks.h"
#include "analysis/sleeve_profile.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace encased_column {

/// Reads `folder`/sleeve.csv; nothing if the run wrote none, as plain ones do not. Throws
/// InputError if a column is missing or holds a word that is no number.
std::optional<SleeveRecord> read_sleeve_record(const std::filesystem::path& folder);

/// Reads `folder`/profile.csv in the same way; none if the run wrote none.
std::vector<SleeveProfile> read_sleeve_profiles(const std::filesystem::path& folder);

}  // namespace encased_column
