#pragma once

#include "analysis/contact_forces.h"
#include "analysis/measuring_spheres.h"
#include "reading/case_run.h"

#include <vector>

namespace encased_column {

/// Reads spheres.csv of `run`: its measuring spheres from the bottom, none if it wrote none.
/// Axial strains are those of the history at the same step. Throws InputError if a column is
/// missing or holds a word that is no number.
std::vector<SphereSeries> read_spheres(const CaseRun& run);

/// Reads contacts.csv in the same way, with the force levels it has; none if the run wrote none.
std::vector<ContactSample> read_contacts(const CaseRun& run);

}  // namespace encased_column
