#pragma once

#include "runner/setting.h"

#include <filesystem>
#include <string>

namespace encased_column {

/// The file in which a run says which variables it uses (`record_variables file variables.csv`).
inline const char* const variables_file = "variables.csv";

/// Reads it: name and value of each variable the host knew. Throws InputError for a file that is
/// none.
Settings read_used_variables(const std::filesystem::path& file);

/// Those of `used` that `asked` names, in its order. Throws InputError, for the case `id`, where
/// the run used another value than it was asked to, or does not know a variable at all.
Settings confirmed_variables(const std::string& id, const Settings& asked, const Settings& used);

}  // namespace encased_column
