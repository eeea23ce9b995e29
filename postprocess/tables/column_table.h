#pragma once

#include "tables/evaluation.h"
#include "tables/text_layout.h"

namespace encased_column {

/// The measuring spheres of `test` before and after shear, a row each, with their mean and what the
/// walls say beside it; only the headings if the run has no spheres.
Rows column_rows(const TestResult& test);

}  // namespace encased_column
