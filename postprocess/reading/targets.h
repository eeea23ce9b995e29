#pragma once

#include "analysis/sleeve_record.h"
#include "analysis/strength.h"
#include "reading/text_table.h"

#include <filesystem>
#include <optional>
#include <string>

namespace encased_column {

/// What the study gives for one quantity, in the table's own unit.
struct Published {
  std::optional<double> laboratory;
  std::optional<double> model;  ///< the study's own numerical model
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

  /// The last step of the strip test of the geotextile.
  std::optional<StripLimit> strip_limit() const;

 private:
  TextTable table_;
};

/// "sigma3=50 kPa", as the table's conditions spell it.
std::string confining_condition(double confining_stress);

}  // namespace encased_column
