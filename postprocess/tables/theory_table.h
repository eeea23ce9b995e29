#pragma once

#include "tables/evaluation.h"
#include "tables/text_layout.h"

#include <string>
#include <vector>

namespace encased_column {

/// Headings, and a row for each encased test and strain; only the headings if no encased test wrote
/// a sleeve record.
Rows theory_rows(const std::vector<SetResult>& sets);

/// Both platens of the encased tests beside the closed form, at 5, 10, 15 and 20 % axial strain as
/// far as a test went, for reading; empty if no encased test wrote a sleeve record.
std::string theory_text(const std::vector<SetResult>& sets);

/// The same as CSV.
std::string theory_csv(const std::vector<SetResult>& sets);

}  // namespace encased_column
