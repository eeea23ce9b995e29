#pragma once

#include "drawing/figure.h"
#include "report/page_parts.h"
#include "tables/evaluation.h"
#include "tables/text_layout.h"

#include <vector>

namespace encased_column {

/// Each figure of the study's results and which of `figures` and `pictures` of the run `test`
/// stand beside it, or why none does; below a row of headings.
Rows counterpart_rows(const TestResult& test, const std::vector<Figure>& figures,
                      const std::vector<Picture>& pictures);

}  // namespace encased_column
