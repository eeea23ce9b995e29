// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "analysis/relative_density.h"
#include "analysis/sleeve_record.h"
#include "analysis/strength.h"
#include "analysis/target_condition.h"
#include "reading/text_table.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// What the study gives for one quantity, in the table's own unit.
struct Published {
  std::optional<double> laboratory;
  std::optional<double> model;  ///< the study's own numerical model
};

/// A row as it stands in the file.
struct TargetRow {
  std::string set, quantity, unit, condition, source;
  Published published;
  /// What its words say about the test.
  TargetCondition words() const { return target_condition(quantity + "; " + condition); }
};

/// The published values, looked up by set, quantity and condition.
class Targets {
 public:
  explicit Targets(const std::filesystem::path& file);

  /// The row of `set` whose quantity starts with `quantity` and whose condition starts with
  /// `condition`; both values absent if there is none.
  Published find(const std::string& set, const std::string& quantity,
                 const std::string& condition) const;

  /// The published strength of `set`, of the laboratory or of the model.
  std::optional<Strength> strength(const std::string& set, bool laboratory) const;

  /// Porosities of the laboratory's samples and their relative densities (Table 6).
  std::vector<DensityPoint> densities() const;

  /// All rows, in order.
  std::vector<TargetRow> all() const;

  /// The rows of `set` whose quantity starts with `quantity`.
  std::vector<TargetRow> rows_of(const std::string& set, const std::string& quantity) const;

  /// The last step of the strip test of the geotextile.
  std::optional<StripLimit> strip_limit() const;

 private:
  TextTable table_;
};

/// "sigma3=50 kPa", as the table's conditions spell it.
std::string confining_condition(double confining_stress);

}  // namespace encased_column
