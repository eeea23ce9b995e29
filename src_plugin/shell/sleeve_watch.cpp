// SPDX-License-Identifier: GPL-2.0-only
#include "shell/sleeve_watch.h"

#include "core/input_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace encased_column {

namespace {

/// Distance [m] between platen and end of the sleeve that no grain of a test passes through.
constexpr double end_tolerance = 1e-4;

}  // namespace

void SleeveWatch::look_at_ends(const ShellModel& model, const std::vector<int> (&end_nodes)[2],
                               const HeightWindow& window, const std::string& id,
                               const std::array<std::string, 2>& platens, long step,
                               std::vector<std::string>& sentences)
{
  const double heights[2] = {window.high, window.low};
  for (int n = 0; n < 2; ++n) {
    const double upwards = n == 0 ? 1.0 : -1.0;
    double beyond = std::numeric_limits<double>::infinity();
    for (const int node : end_nodes[n])
      beyond = std::min(beyond, upwards * (heights[n] - model.position()[node].z()));
    if (platen_told_[n] || !std::isfinite(heights[n]) || beyond <= end_tolerance) continue;
    platen_told_[n] = true;
    sentences.push_back("platen '" + platens[n] + "' stands " + in_words(beyond) +
                        " m beyond the end of sleeve '" + id + "' at step " + std::to_string(step) +
                        ", grains can escape there: hold the platen or make the sleeve longer");
  }
}

void SleeveWatch::look_at_strength(const ShellModel& model, const std::string& id, long step,
                                   std::vector<std::string>& sentences)
{
  const Cloth& cloth = model.material().cloth();
  for (int i = 0; i < 2; ++i) {
    const double limit = cloth.warned_of(i);
    if (strength_told_[i] || !std::isfinite(limit)) continue;
    double largest = 0.0, most = 0.0;  // tension over its facet's limit, and that tension
    for (int f = 0; f < model.facets(); ++f) {
      const double tension = model.facet_state(f).membrane_force(i);
      const double ratio = tension / (limit * model.strength_share(i, f));
      if (ratio <= largest) continue;
      largest = ratio;
      most = tension;
    }
    if (largest <= 1.0) continue;
    strength_told_[i] = true;
    const bool is_strength = cloth.constants().strength[i] > 0.0;
    sentences.push_back("the " + std::string(i == 0 ? "hoop" : "axial") + " tension of sleeve '" +
                        id + "' is " + in_words(most) + " N/m at step " + std::to_string(step) +
                        " and passes " +
                        (is_strength ? "its 'strength' of " : "the last reading of 'strip', ") +
                        in_words(most / largest) +
                        " N/m; it does not tear, write 'after_strength yield' or 'after_strength "
                        "tear' if it should");
  }
}

}  // namespace encased_column
