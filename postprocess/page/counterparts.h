#pragma once

#include "drawing/figure.h"
#include "report/evaluation.h"
#include "report/text_layout.h"

#include <vector>

namespace encased_column {

/// Each figure of the study's results and which of `figures` and `pictures` (their number) of the
/// run `test` stands beside it, or why none does; below a row of headings.
Rows counterpart_rows(const TestResult& test, const std::vector<Figure>& figures,
                      std::size_t pictures);

}  // namespace encased_column
