// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "analysis/inside_specimen.h"
#include "analysis/sleeve_record.h"
#include "reading/case_run.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace encased_column {

/// Reads spheres.csv of `run`: its measuring spheres from the bottom, none if it wrote none.
/// Axial strains are those of the history at the same step. Throws InputError if a column is
/// missing or holds a word that is no number.
std::vector<SphereSeries> read_spheres(const CaseRun& run);

/// Reads contacts.csv in the same way, with the force levels it has; none if the run wrote none.
std::vector<ContactSample> read_contacts(const CaseRun& run);

/// Reads `folder`/sleeve.csv; nothing if the run wrote none, as plain ones do not. Throws
/// InputError if a column is missing or holds a word that is no number.
std::optional<SleeveRecord> read_sleeve_record(const std::filesystem::path& folder);

/// Reads `folder`/profile.csv in the same way; none if the run wrote none.
std::vector<SleeveProfile> read_sleeve_profiles(const std::filesystem::path& folder);

}  // namespace encased_column
