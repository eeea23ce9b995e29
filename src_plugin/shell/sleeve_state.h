// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/constants.h"
#include "core/input_error.h"
#include "shell/height_window.h"
#include "shell/shell_model.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace encased_column {

/// What an engineer wants to know of a sleeve; tension and stretch positive.
struct SleeveSummary {
  double area = 0.0;                     ///< of the facets counted [m^2]
  double hoop_tension = 0.0;             ///< mean over the area [N/m]
  double hoop_tension_max = 0.0;         ///< [N/m]
  double hoop_strain = 0.0;              ///< mean over the area [-]
  double hoop_strain_max = 0.0;          ///< [-]
  double plastic_hoop_strain_max = 0.0;  ///< [-]
  double damage_max = 0.0;               ///< of either direction, 1: torn [-]
};

/// Means over the facets whose centers lie in the window, and the largest values of any facet.
inline SleeveSummary summary_of(const ShellModel& model, const HeightWindow& window)
{
  SleeveSummary out;
  for (int f = 0; f < model.facets(); ++f) {
    const FacetState state = model.facet_state(f);
    out.hoop_tension_max = std::max(out.hoop_tension_max, state.membrane_force(0));
    out.hoop_strain_max = std::max(out.hoop_strain_max, state.strain(0));
    const FacetMemory memory = model.memory(f);
    out.plastic_hoop_strain_max = std::max(out.plastic_hoop_strain_max, memory.plastic_strain[0]);
    out.damage_max = std::max({out.damage_max, memory.damage[0], memory.damage[1]});
    const FacetVectors x = model.corners(f);
    const double z = (x[0].z() + x[1].z() + x[2].z()) / 3.0;
    if (z < window.low || z > window.high) continue;
    const double area = model.element()[f].area();
    out.area += area;
    out.hoop_tension += area * state.membrane_force(0);
    out.hoop_strain += area * state.strain(0);
  }
  if (out.area > 0.0) {
    out.hoop_tension /= out.area;
    out.hoop_strain /= out.area;
  }
  return out;
}

/// What to do about a sleeve that fails: soon after its release nothing can be slowed, the grains
/// that were packed in it while it was rigid burst it. `released` is the number of steps since
/// then, below zero where it never was rigid; `otherwise` helps against a load.
inline std::string advice_for(long released, const std::string& otherwise)
{
  constexpr long soon = 1000;  // the specimen swells against the sleeve within a few hundred steps
  if (released < 0 || released > soon) return otherwise;
  return std::to_string(released) +
         " steps after its release, when the grains packed in it while it was 'rigid' press on it: "
         "pack them looser, write a larger 'thickness' or 'modulus' or longer facets";
}

/// The first of facets [first, last) that is torn through, as a sentence with its place in the
/// sleeve without load; `axis` is a point of the center line.
inline std::optional<std::string> torn_facet(const ShellModel& model, int first, int last,
                                             const Vec3& axis)
{
  if (!model.material().cloth().tears()) return {};
  for (int f = first; f < last; ++f)
    for (int i = 0; i < 2; ++i) {
      if (model.memory(f).damage[i] < Cloth::torn) continue;
      Vec3 center = -axis;
      for (const int node : model.facet()[f]) center += model.reference()[node] / 3.0;
      const double degrees = std::atan2(center.y(), center.x()) * 180.0 / pi;
      return "facet " + std::to_string(f) + " of the sleeve is torn through" +
             (i == 0 ? " by its hoop tension" : " by its axial tension") + " at height " +
             in_words(center.z()) + " m and " + std::to_string(std::lround(degrees)) +
             " degrees from x" + (model.strength_share(i, f) < 1.0 ? ", on the seam" : "") +
             ": the test ends here, write 'when_torn go_on' to see what comes after";
    }
  return {};
}

/// What is wrong with one of facets [first, last), as a sentence; empty when all are sound. A facet
/// is over-stretched when a principal strain exceeds `limit` [-], either way where the membrane
/// bears compression.
inline std::optional<std::string> fault_of_facets(const ShellModel& model, int first, int last,
                                                  double limit, long released = -1)
{
  for (int f = first; f < last; ++f) {
    const FacetVectors x = model.corners(f);
    const double sum = x[0].sum() + x[1].sum() + x[2].sum();
    if (!std::isfinite(sum))
      return "facet " + std::to_string(f) +
             " of the sleeve has a position that is not a number, go back to the last restart file "
             "with a smaller step";
    const FacetMemory memory = model.memory(f);
    if (memory.damage[0] > 0.0 || memory.damage[1] > 0.0) continue;  // it opens as it tears
    const FacetState state = model.facet_state(f);
    // What wrinkles is not compressed: its strain is that of the plane it has left.
    const double pushed = model.material().constants().tension_only ? 0.0 : -state.smallest_strain;
    const double strain = std::max(state.largest_strain, pushed);
    if (!(strain <= limit))
      return "facet " + std::to_string(f) + " of the sleeve is strained by " + in_words(strain) +
             ", the 'strain_limit' is " + in_words(limit) + ", " +
             advice_for(released,
                        "slow the loading, look at the sleeve there or write a larger limit");
  }
  return {};
}

/// The same for pairs of neighbours: folded over by more than 120 degrees, one of them is inverted.
inline std::optional<std::string> fault_of_pairs(const ShellModel& model,
                                                 const std::vector<std::array<int, 2>>& pairs)
{
  const auto normal = [&model](int f) -> Vec3 {
    const FacetVectors x = model.corners(f);
    return (x[1] - x[0]).cross(x[2] - x[0]).normalized();
  };
  // One that tears has the shape of its gap.
  const auto tears = [&model](int f) { return model.memory(f).left() < 1.0; };
  for (const auto& [a, b] : pairs)
    if (normal(a).dot(normal(b)) < -0.5 && !tears(a) && !tears(b))
      return "facets " + std::to_string(a) + " and " + std::to_string(b) +
             " of the sleeve are folded on each other, one is inverted: use shorter facets, a "
             "larger "
             "'bending_thickness' or a slower load";
  return {};
}

}  // namespace encased_column
