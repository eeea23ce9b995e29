#pragma once

#include "drawing/figure.h"
#include "page/page_parts.h"
#include "report/evaluation.h"
#include "report/text_layout.h"

#include <vector>

namespace encased_column {

/// Each figure of the study's results and which of `figures` and `pictures` of the run `test`
/// stand beside it, or why none does; below a row of headings.
Rows counterpart_rows(const TestResult& test, const std::vector<Figure>& figures,
                      const std::vector<Picture>& pictures);

}  // namespace encased_column
