// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/input_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace encased_column {

/// A reading of a strip test.
struct StripPoint {
  double strain;   ///< [-]
  double tension;  ///< [N/m]
};

/// Part of the limit of a strip that is straight in its plastic strain.
struct YieldLine {
  static constexpr double never = 1e300;  ///< finite, so that differences to it are

  double origin = 0.0;     ///< plastic strain at `tension` [-]
  double tension = never;  ///< [N/m]
  double slope = 0.0;      ///< [N/m]
  double end = never;      ///< plastic strain up to which it holds [-]
};

/// Throws InputError unless the table starts at (0, 0), its strains increase and its tensions do
/// not fall; `direction` is "hoop" or "axial".
inline void check_strip(const std::vector<StripPoint>& table, const std::string& direction)
{
  const auto refuse = [](const std::string& rule, const std::string& found,
                         const std::string& advice) {
    throw InputError("the table of 'strip' " + rule + ", found " + found + ": " + advice);
  };
  if (table.size() < 2)
    refuse("needs two rows or more", std::to_string(table.size()),
           "write one row for each reading");
  if (table[0].strain != 0.0 || table[0].tension != 0.0)
    refuse("must start at 0 strain and 0 " + direction + " tension",
           in_words(table[0].strain) + " and " + in_words(table[0].tension) + " N/m",
           "add the row '0,0,0'");
  for (std::size_t n = 1; n < table.size(); ++n) {
    const std::string row = " in row " + std::to_string(n + 1);
    if (!(table[n].strain > table[n - 1].strain))
      refuse("must have strains that increase from row to row",
             in_words(table[n].strain) + " after " + in_words(table[n - 1].strain) + row,
             "put the rows in order");
    if (!(table[n].tension >= 0.0))
      refuse("must have no negative tension",
             in_words(table[n].tension) + " N/m in the " + direction + " direction" + row,
             "write tensions as positive numbers");
    if (table[n].tension < table[n - 1].tension)
      refuse("must have tensions that do not fall from row to row",
             in_words(table[n].tension) + " after " + in_words(table[n - 1].tension) +
                 " N/m in the " + direction + " direction" + row,
             "end the table at the peak and write 'strength' and 'after_strength tear'");
  }
}

/// Tension at which a strip yields, by the plastic strain it has: its table with the elastic strain
/// N / J taken off. Behind the last row its last slope goes on. Without a table nothing yields.
class StripCurve {
 public:
  StripCurve() = default;
  /// `stiffness` J [N/m] is that of unloading; throws InputError where the table is stiffer.
  StripCurve(const std::vector<StripPoint>& table, double stiffness, const std::string& direction)
  {
    for (std::size_t n = 1; n < table.size(); ++n) {
      const double slope =
          (table[n].tension - table[n - 1].tension) / (table[n].strain - table[n - 1].strain);
      if (slope > stiffness * (1.0 + nearly_elastic))
        throw InputError(
            "a strip unloads no softer than it loads: 'modulus' times 'thickness' must "
            "be at least the steepest slope of the table of 'strip', found " +
            in_words(stiffness) + " N/m and " + in_words(slope) + " N/m in the " + direction +
            " direction: write a larger modulus");
      // A part as steep as the unloading is elastic: there the limit rises without plastic strain.
      const double plastic = slope > stiffness * (1.0 - nearly_elastic)
                                 ? (plastic_.empty() ? 0.0 : plastic_.back())
                                 : table[n].strain - table[n].tension / stiffness;
      if (n == 1 && plastic > 0.0) add(0.0, 0.0);
      add(plastic, table[n].tension);
    }
    const std::size_t last = plastic_.size() - 1;
    if (last > 0 && plastic_[last] > plastic_[last - 1])
      last_slope_ = (tension_[last] - tension_[last - 1]) / (plastic_[last] - plastic_[last - 1]);
    else
      last_slope_ = std::numeric_limits<double>::infinity();
  }

  bool yields() const { return !plastic_.empty() && (plastic_.size() > 1 || last_slope_ < 1e300); }

  /// Tension [N/m] at which plastic strain grows on; infinite where nothing yields.
  double limit(double plastic) const
  {
    if (plastic_.empty()) return std::numeric_limits<double>::infinity();
    const std::size_t n = segment(plastic);
    if (n + 1 == plastic_.size())
      return std::isfinite(last_slope_) ? tension_[n] + last_slope_ * (plastic - plastic_[n])
                                        : last_slope_;
    return tension_[n] + slope(n) * (plastic - plastic_[n]);
  }

  /// The line on which the limit lies from a plastic strain on.
  YieldLine line(double plastic) const
  {
    if (plastic_.empty()) return {};
    const std::size_t n = segment(plastic);
    if (n + 1 < plastic_.size()) return {plastic_[n], tension_[n], slope(n), plastic_[n + 1]};
    if (!std::isfinite(last_slope_)) return {};
    return {plastic_[n], tension_[n], last_slope_, YieldLine::never};
  }

  /// Plastic strain by which a strip of elastic tension `trial` [N/m] at the plastic strain
  /// `plastic` grows so that trial - D growth is the limit; D [N/m] is how fast it relaxes.
  double growth(double plastic, double trial, double relaxation) const
  {
    if (!(trial > limit(plastic))) return 0.0;
    double at = plastic;
    for (std::size_t n = segment(plastic);; ++n) {
      const bool is_last = n + 1 == plastic_.size();
      if (!is_last && plastic_[n + 1] == plastic_[n]) continue;
      if (is_last && !std::isfinite(last_slope_)) return at - plastic;
      const double rise = is_last ? last_slope_ : slope(n);
      const double step = (trial - relaxation * (at - plastic) - limit(at)) / (relaxation + rise);
      if (step <= 0.0) return at - plastic;
      if (is_last || at + step <= plastic_[n + 1]) return at + step - plastic;
      at = plastic_[n + 1];
    }
  }

 private:
  static constexpr double nearly_elastic = 1e-9;

  void add(double plastic, double tension)
  {
    // Where the limit rises at once the curve has two points, the last of which counts.
    const std::size_t n = plastic_.size();
    const bool rises = n > 0 && plastic <= plastic_[n - 1];
    if (rises && (n == 1 || plastic_[n - 2] == plastic_[n - 1])) {
      tension_[n - 1] = tension;
      return;
    }
    if (rises) plastic = plastic_[n - 1];
    plastic_.push_back(plastic);
    tension_.push_back(tension);
  }
  /// The last point at or before a plastic strain.
  std::size_t segment(double plastic) const
  {
    std::size_t n = 0;
    while (n + 1 < plastic_.size() && plastic_[n + 1] <= plastic) ++n;
    return n;
  }
  double slope(std::size_t n) const
  {
    return (tension_[n + 1] - tension_[n]) / (plastic_[n + 1] - plastic_[n]);
  }

  std::vector<double> plastic_, tension_;
  double last_slope_ = 0.0;
};

}  // namespace encased_column
