// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "files/column.h"
#include "measure/contact_force.h"

#include <string>
#include <vector>

namespace encased_column {

class Options;

/// One row of the statistics of contacts.
struct ContactStatistics {
  double step;
  const ContactForces& forces;
};

/// Its columns but for those of the levels, in their order.
const std::vector<Column<ContactStatistics>>& contact_columns();

/// The levels [N] that the keyword `level` asks for; throws InputError.
std::vector<double> contact_levels(const Options& options);

/// All headings, with two columns for each of `levels` [N].
std::vector<std::string> contact_headings(const std::vector<double>& levels);
/// All numbers in their order.
std::vector<double> contact_numbers(const ContactStatistics& sample);
/// What the user page lists, the level as L.
std::vector<ColumnText> contact_texts();

}  // namespace encased_column
