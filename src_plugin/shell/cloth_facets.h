#pragma once

#include "shell/cloth.h"

#include <vector>

namespace encased_column {

class ShellElement;

constexpr int facets_in_batch = 32;

/// What the loads of a batch take from the memory of its facets.
struct ClothRows {
  using Numbers = double[facets_in_batch];
  Numbers plastic_strain[2];
  /// Force above which the facet has to be looked at [N/m]: none where it tears, any once torn.
  Numbers limit[2];
  Numbers left;       ///< of its stiffness [-]
  Numbers slip;       ///< [-]
  bool torn = false;  ///< some facet has damage
};

/// How the facets of a batch stand, as ClothAnswer but with the energy of the whole facet [J].
struct ClothAnswers {
  using Numbers = double[facets_in_batch];
  Numbers force[3], elastic_shear, energy;
};

/// The facets of a cloth: what each remembers, side by side in batches.
///
/// The loads of a step are found with the memory as it stands. What is above its limit then asks
/// for more plastic strain or damage, one Cloth::follow() each, which the facet has from the next
/// step on: so a force is above its limit by what a step or a few brought. A set-up, which advances
/// nothing, finds the loads of the step before again, to the last bit.
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
  const ClothRows& rows(int batch) const { return rows_[batch]; }
  const std::vector<FacetMemory>& memory() const { return memory_; }
  void set_memory(int facet, const FacetMemory& memory);

  /// Facets [first, last) get the memory they asked for, unless `at_set_up`; either way they ask
  /// again from their next loads.
  void advance(int first, int last, bool at_set_up);
  /// Lets the facets [first, last) of a batch ask for what their loads want.
  void ask(int batch, int first, int last, const ClothAnswers& answers);
  double dissipated() const { return dissipated_; }  ///< by what was asked for and given [J]
  void set_dissipated(double energy) { dissipated_ = energy; }

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
  std::vector<FacetMemory> memory_;
  std::vector<ClothRows> rows_;
  std::vector<Wish> wish_;  ///< room for all facets
  double dissipated_ = 0.0;
};

}  // namespace encased_column
