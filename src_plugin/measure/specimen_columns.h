#pragma once

#include "files/column.h"
#include "measure/specimen_sums.h"

#include <vector>

namespace encased_column {

/// The columns of a specimen's history, in their order.
const std::vector<Column<SpecimenSample>>& specimen_columns();

}  // namespace encased_column
