// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/targets.h"
#include "tables/evaluation.h"
#include "tables/text_layout.h"

#include <string>
#include <vector>

namespace encased_column {

/// One quantity beside what the study gives for it.
struct ResultRow {
  std::string test;  ///< id of the run, or "all" for what a set gives together
  std::string quantity;
  std::string unit;
  double value;  ///< in `unit`
  int decimals;  ///< to print
  Published published;
};

/// The rows of `set`: E50 and peak q of each test, friction angle and cohesion of all, porosities
/// and numbers of grains, and for encased tests the radial strains at the end and
/// the largest hoop tension.
std::vector<ResultRow> result_rows(const SetResult& set, const Targets& targets);

/// The headings of rows as words, and a row as words below them; "-" for what there is none of.
extern const std::vector<std::string> result_headings;
std::vector<std::string> as_words(const ResultRow& row);

/// The sets as one CSV table with differences in percent of the published values.
std::string result_csv(const std::vector<SetResult>& sets, const Targets& targets);

/// The same for reading, with the notes below each set.
std::string result_text(const std::vector<SetResult>& sets, const Targets& targets);

}  // namespace encased_column
