// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/grain_reach.h"
#include "contact/resolve_contact.h"
#include "shell/facet_grid.h"
#include "shell/facet_touches.h"
#include "shell/shell_model.h"

#include <array>
#include <optional>
#include <type_traits>
#include <vector>

namespace encased_column {

/// A grain that touches the sleeve, as the contact law sees it.
struct SleeveContact {
  int n;      ///< its place in the list
  int grain;  ///< its number
  MergedContact merged;
  SurfaceMotion surface;  ///< the motion on which shear force and moment do their work

  /// The sleeve as a body without radius, which has its center where the overlap ends.
  ContactBody body() const
  {
    return {0.0, surface.velocity - 0.5 * merged.overlap * surface.spin.cross(merged.normal),
            surface.spin};
  }
};

/// What the contact law answers.
struct SleeveReaction {
  double normal_force;  ///< [N]
  Vec3 force;           ///< on the grain [N]
  Vec3 moment;          ///< on the sleeve, about the contact [N m]
  double stiffness;     ///< larger one of the contact's springs [N/m]
};

/// A grain whose center lies behind the facet it is deepest in.
struct GrainBehind {
  int grain, facet;
};

/// Contacts of grains with a sleeve: which facets are near each grain, how a grain and they
/// overlap, and how the contact force reaches the nodes. Contacts are seen to in blocks, whose
/// facets lie side by side. A block is full but for the last one, so what is in it depends on the
/// contacts alone, and sums over a block repeat after a restart.
class SleeveContacts {
 public:
  static constexpr int in_block = 32;  ///< contacts at most

  /// Lists, for `grains` centers [m] in a row of triples, the facets within radius, twice its
  /// `reach` and half the margin, which is the skin [m]. The list holds while no grain moves
  /// further than twice its reach and no node than half the margin. What is listed is looked at
  /// again only where grain and sleeve may have closed the gap between them since they were looked
  /// at.
  void list(const ShellModel& model, const double* centers, const double* radii, int grains,
            const GrainReach& reach);
  /// Lists the facets of those anew whose reach got wider since.
  void add_wider(const ShellModel& model, const double* centers, const double* radii, int grains,
                 const GrainReach& reach);
  /// True once a node has moved more than half the margin since list().
  bool is_stale(const ShellModel& model) const;
  /// Listed grains, in the order of their numbers.
  const std::vector<int>& grains() const { return grain_; }

  /// For each listed grain that touches, asks `law` and gives the sleeve what it feels: the normal
  /// force along the facets' directions, shear force and moment at the contact; nodal forces are
  /// statically equivalent. `law` answers a contact, a SleeveReaction of a SleeveContact, or those
  /// of a block at once: (contacts, their number, reactions). Grains tells `centers`, `radii` and
  /// whether a grain `counts(i)`. A sleeve that stands still takes no load: `moves` is false. With
  /// `bound`, adds to it what each contact adds to the stiffness of its nodes. Ends at the first
  /// grain that is behind the sleeve.
  template <typename Grains, typename Law>
  std::optional<GrainBehind> resolve(ShellModel& model, bool moves, const Grains& grains,
                                     std::vector<StiffnessBound>* bound, const Law& law)
  {
    vertical_force_ = 0.0;
    touches_.clear();
    contacts_ = 0;
    for (std::size_t n = 0; n < grain_.size();) {
      n = look_at_some(model, grains, n);
      if (const auto behind = find_contacts()) return behind;
      while (contacts_ >= in_block) settle(in_block, model, moves, bound, law);
    }
    if (contacts_ > 0) settle(contacts_, model, moves, bound, law);
    return {};
  }
  /// Of the grains on the sleeve, in the last resolve() [N].
  double vertical_force() const { return vertical_force_; }

 private:
  /// A grain near the sleeve, and where all was when the gaps to its facets were found.
  struct Near {
    int begin, end;     ///< its facets in the list
    int close;          ///< so many of them can be reached before all are looked at again
    double clear;       ///< smallest of its gaps [m]
    double clear_rest;  ///< of those that are not close [m]
    Vec3 center;
    double radius, travel;  ///< its own [m]; of the sleeve, ShellModel::travel()
  };
  /// A grain that is looked at and its pairs.
  struct Look {
    int n, first, last;
    double closed;  ///< by how much its gaps may have closed [m]
    double moved;   ///< by the grain [m]
    bool all;       ///< of its facets are looked at
  };
  /// Pairs of a contact, from `first` to before `last`.
  struct Pairs {
    int first, last;
  };

  template <typename Grains>
  std::size_t look_at_some(const ShellModel& model, const Grains& grains, std::size_t n)
  {
    looks_ = 0;
    for (; n < grain_.size() && looks_ < in_block; ++n) {
      const Near& near = near_[n];
      const int i = grain_[n];
      const Vec3 center = as_vec3(grains.centers + 3 * i);
      // By how much its gaps may have closed without the way of the grain, and by that too.
      const double closed = (model.travel() - near.travel) + (grains.radii[i] - near.radius);
      const double left = near.clear - closed;
      if (left > 0.0 && (center - near.center).squaredNorm() < left * left) continue;
      if (!grains.counts(i)) continue;
      if (looks_ > 0 && !touches_.has_room(near.end - near.begin)) break;
      look_at(model, static_cast<int>(n), center, grains.radii[i], closed);
    }
    return n;
  }
  /// Sees to the first `count` contacts and forgets them.
  template <typename Law>
  void settle(int count, ShellModel& model, bool moves, std::vector<StiffnessBound>* bound,
              const Law& law)
  {
    if (moves) find_motion(count, model);
    if constexpr (std::is_invocable_v<const Law&, const SleeveContact&>)
      for (int c = 0; c < count; ++c) reaction_[c] = law(contact_[c]);
    else
      law(contact_.data(), count, reaction_.data());
    take_reactions(count, model, moves, bound);
    forget(count);
  }

  Near find_facets(const ShellModel& model, const Vec3& center, double radius, double reach);
  void make_room();
  void look_at(const ShellModel& model, int n, const Vec3& center, double radius, double closed);
  void take_gaps(const Look& look);
  std::optional<GrainBehind> find_contacts();
  bool is_behind(const Pairs& pairs) const;
  void merge(const Pairs& pairs, MergedContact& merged);
  void find_motion(int count, const ShellModel& model);
  void take_reactions(int count, ShellModel& model, bool moves, std::vector<StiffnessBound>* bound);
  void forget(int count);
  void add_stiffness(int p, double stiffness, std::vector<StiffnessBound>& bound) const;

  FacetGrid grid_;
  double margin_ = 0.0, listed_travel_ = 0.0, vertical_force_ = 0.0;
  std::vector<Vec3> listed_position_;
  std::vector<int> grain_;
  std::vector<Near> near_;   ///< of each grain
  std::vector<int> facet_;   ///< of all grains, those of a grain in a row
  std::vector<int> close_;   ///< the close ones of each grain, from its `begin` on
  std::vector<double> gap_;  ///< of each of these, between it and its grain [m]
  // Grains that are looked at, contacts that were found and not yet seen to:
  int looks_ = 0, contacts_ = 0;
  std::array<Look, in_block> look_;
  std::array<SleeveContact, 2 * in_block> contact_;
  std::array<Pairs, 2 * in_block> pairs_;
  std::array<SleeveReaction, in_block> reaction_;
  FacetTouches touches_;
  std::vector<FacetTouch> merged_;
};

}  // namespace encased_column
