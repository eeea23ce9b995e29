// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/grain_reach.h"
#include "contact/resolve_contact.h"
#include "shell/facet_grid.h"
#include "shell/facet_touches.h"
#include "shell/shell_model.h"

#include <array>
#include <limits>
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
  /// Facets near them, one after the other, some more than once.
  const std::vector<int>& facets() const { return facet_; }

  /// For each listed grain that touches, asks `law` and gives the sleeve what it feels: the normal
  /// force along the facets' directions, shear force and moment at the contact; nodal forces are
  /// statically equivalent. `law` answers a contact, a SleeveReaction of a SleeveContact, or those
  /// of a block at once: (contacts, their number, reactions). Grains tells `centers`, `radii`,
  /// after a new list whether a grain `counts(i)`, and may `fetch(n, i)` into the cache what the
  /// law is likely to need soon of grain i, which is grains()[n]. A sleeve that stands still takes
  /// no load: `moves` is false. With `bound`, adds to it what each contact adds to the stiffness of
  /// its nodes. Ends at the first grain that is behind the sleeve.
  template <typename Grains, typename Law>
  std::optional<GrainBehind> resolve(ShellModel& model, bool moves, const Grains& grains,
                                     std::vector<StiffnessBound>* bound, const Law& law)
  {
    vertical_force_ = 0.0;
    touches_.clear();
    contacts_ = 0;
    pick(model, grains);
    for (int m = 0; m < picked_;) {
      m = look_at_some(model, grains, m);
      if (const auto behind = find_contacts()) return behind;
      while (contacts_ >= in_block) settle(in_block, model, moves, bound, law);
    }
    if (contacts_ > 0) settle(contacts_, model, moves, bound, law);
    return {};
  }
  /// Of the grains on the sleeve, in the last resolve() [N].
  double vertical_force() const { return vertical_force_; }

 private:
  static constexpr int not_known = -1;      ///< how many facets are close
  static constexpr int fetched_ahead = 24;  ///< grains that are looked at

  /// A grain near the sleeve. Gaps of facets that were not looked at with it are what is left of
  /// them at least.
  struct Near {
    int begin, end;      ///< its facets in the list
    int close;           ///< so many of them can be reached before all are looked at again
    double clear_rest;   ///< smallest gap of those that are not close [m]
    double size_travel;  ///< its radius with ShellModel::travel(), when it was looked at last [m]
  };
  /// Where it was then, and its smallest gap with its radius and the travel of the sleeve [m]:
  /// while these have not grown by the gap less its way, it cannot touch.
  struct Hold {
    Vec3 center;
    double until;
  };
  struct Close {
    double gap;  ///< between the facet and the grain [m]
    int facet;
    Facet node;  ///< of the facet: beside it, so as not to wait for it
  };
  /// A grain that is looked at and its pairs.
  struct Look {
    int n, first, last;
    bool all;  ///< of its facets are looked at
  };
  /// Picks the grains to look at, without a branch: which ones cannot be guessed, and a wrong guess
  /// waits for memory.
  template <typename Grains>
  void pick(const ShellModel& model, const Grains& grains)
  {
    picked_ = 0;
    const double travel = model.travel();
    const int all = static_cast<int>(grain_.size());
    for (int n = 0; n < all; ++n) {
      __builtin_prefetch(grains.centers + 3 * grain_[std::min(n + 2 * fetched_ahead, all - 1)]);
      const int i = grain_[n];
      const Hold& hold = hold_[n];
      const double left = hold.until - travel - grains.radii[i];
      const double moved = (as_vec3(grains.centers + 3 * i) - hold.center).squaredNorm();
      pick_[picked_] = n;
      picked_ += !((left > 0.0) & (moved < left * left));
    }
  }
  /// Looks at those picked from number m on, as many as a block has room for; returns the next one.
  template <typename Grains>
  int look_at_some(const ShellModel& model, const Grains& grains, int m)
  {
    looks_ = 0;
    for (; m < picked_ && looks_ < in_block; ++m) {
      if (const int next = m + fetched_ahead; next < picked_) {
        const int n = pick_[next];
        grains.fetch(n, grain_[n]);
        __builtin_prefetch(&close_[near_[n].begin]);
      }
      if (const int next = m + 2 * fetched_ahead; next < picked_)
        __builtin_prefetch(&near_[pick_[next]]);
      const int n = pick_[m], i = grain_[n];
      const Near& near = near_[n];
      if (near.close == not_known && !grains.counts(i)) {
        hold_[n].until = std::numeric_limits<double>::infinity();
        continue;
      }
      if (looks_ > 0 && !touches_.has_room(near.end - near.begin)) break;
      look_at(model, n, as_vec3(grains.centers + 3 * i), grains.radii[i]);
    }
    return m;
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
  static Hold not_looked_at(const Vec3& center);
  void make_room();
  void look_at(const ShellModel& model, int n, const Vec3& center, double radius);
  void take_gaps(const Look& look);
  std::optional<GrainBehind> find_contacts();
  bool is_behind(const FacetPairs& pairs) const;
  void find_motion(int count, const ShellModel& model);
  void take_reactions(int count, ShellModel& model, bool moves, std::vector<StiffnessBound>* bound);
  void forget(int count);
  void add_stiffness(int p, double stiffness, std::vector<StiffnessBound>& bound) const;

  FacetGrid grid_;
  double margin_ = 0.0, listed_travel_ = 0.0, vertical_force_ = 0.0;
  std::vector<Vec3> listed_position_;
  std::vector<int> grain_;
  std::vector<Near> near_;    ///< of each grain
  std::vector<Hold> hold_;    ///< of each grain
  std::vector<int> pick_;     ///< places in the list of those to look at, the first `picked_`
  std::vector<int> facet_;    ///< of all grains, those of a grain in a row
  std::vector<Close> close_;  ///< the close ones of each grain, from its `begin` on
  // Grains that are looked at, contacts that were found and not yet seen to:
  int picked_ = 0, looks_ = 0, contacts_ = 0;
  std::array<Look, in_block> look_;
  std::array<SleeveContact, 2 * in_block> contact_;
  std::array<FacetPairs, 2 * in_block> pairs_;
  std::array<SleeveReaction, in_block> reaction_;
  FacetTouches touches_;
};

}  // namespace encased_column
