// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/cloth.h"

#include <cstddef>
#include <vector>

namespace encased_column {

class ShellElement;

constexpr int facets_in_batch = 32;

/// What the facets of a batch remember and how their limits go on from there, as YieldLine. Without
/// branches, for the vector units.
struct alignas(64) ClothRows {
  using Numbers = double[facets_in_batch];
  bool torn = false;    ///< some facet has damage
  bool yields = false;  ///< some facet has an excess
  alignas(64) Numbers plastic_strain[2];
  Numbers limit[2];   ///< force above which the facet yields or is looked at [N/m]
  Numbers excess[2];  ///< of the force last found above it [N/m]
  Numbers start[2], slope[2], end[2], rate[2];  ///< the limit is start + slope times plastic strain
  Numbers left;                                 ///< of its stiffness [-]
  Numbers slip;                                 ///< [-]

  /// Bytes from the first on that a step looks at.
  std::size_t in_use() const
  {
    return torn || yields ? sizeof(ClothRows) : offsetof(ClothRows, start);
  }

  double limit_at(int i, int n, double plastic) const
  {
    return start[i][n] + slope[i][n] * plastic;
  }
  /// Lets facet n yield in direction i by its excess; returns the energy taken per area [J/m^2].
  double grow(int i, int n)
  {
    const double growth = excess[i][n] * rate[i][n];
    const double before = plastic_strain[i][n], plastic = before + growth;
    plastic_strain[i][n] = plastic;
    limit[i][n] = limit_at(i, n, plastic);
    return 0.5 * (limit_at(i, n, before) + limit[i][n]) * growth;
  }
  /// True where the excess would take facet n beyond the line of direction i.
  bool leaves_its_line(int i, int n) const
  {
    return (excess[i][n] > 0.0) & (plastic_strain[i][n] + excess[i][n] * rate[i][n] >= end[i][n]);
  }
  bool leaves_its_line(int n) const { return leaves_its_line(0, n) | leaves_its_line(1, n); }
};

/// How the facets of a batch stand, as ClothAnswer but with the energy of the whole facet [J].
struct ClothAnswers {
  using Numbers = double[facets_in_batch];
  Numbers force[3], elastic_shear, energy;
};

/// The facets of a cloth: what each remembers, side by side in batches.
///
/// The loads of a step are found with the memory as it stands. What is above its limit then asks
/// for more plastic strain or damage, which the facet has from the next step on: so a force is
/// above its limit by what a step or a few brought. On one straight part of its limit all of a
/// batch grow at once, the excess over D + Y' each; the others take Cloth::follow(). A set-up,
/// which advances nothing, finds the loads of the step before again, to the last bit.
class ClothFacets {
 public:
  ClothFacets() = default;
  /// Throws InputError where a facet would snap back while it tears.
  ClothFacets(const std::vector<ShellElement>& element, const Cloth& cloth);

  /// Gives facets of a seam their share of the hoop strength [-].
  void weaken(const std::vector<int>& facets, double share);

  double strength_share(int direction, int facet) const
  {
    return facet_[facet].strength[direction];
  }
  bool softens_off_axis() const { return cloth_.softens_off_axis(); }
  bool remembers() const { return remembers_; }
  const EvenStiffness& whole() const { return cloth_.whole(); }
  ClothRows& rows(int batch) { return rows_[batch]; }
  bool empty() const { return memory_.empty(); }
  FacetMemory memory(int facet) const;
  void set_memory(int facet, const FacetMemory& memory);

  /// Facets [first, last) get the memory they asked for, unless `at_set_up`; either way they ask
  /// again from their next loads.
  void advance(int first, int last, bool at_set_up);
  /// Lets [first, last) of a batch yield by the excess of their last loads.
  void grow(int batch, int first, int last);
  /// Whether a facet of [first, last) of a batch, whose excess was found, has to ask.
  static bool must_ask(const ClothRows& rows, int first, int last);
  /// Lets those ask for what their loads want.
  void ask(int batch, int first, int last, const ClothAnswers& answers);
  double dissipated() const { return dissipated_; }  ///< by what was asked for and given [J]
  void set_dissipated(double energy) { dissipated_ = energy; }
  void dissipate(double energy) { dissipated_ += energy; }

 private:
  /// The memory a facet has from the next step on.
  struct Wish {
    int facet;
    FacetMemory memory;
    double taken;  ///< energy [J]
  };

  Cloth cloth_;
  bool remembers_ = false;
  std::vector<ClothFacet> facet_;
  std::vector<double> area_;
  std::vector<FacetMemory> memory_;  ///< but for the plastic strains, which are in the rows
  std::vector<ClothRows> rows_;
  std::vector<Wish> wish_;  ///< room for all facets
  double dissipated_ = 0.0;
};

}  // namespace encased_column
