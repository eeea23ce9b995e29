// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "contact/resolve_contact.h"
#include "shell/contact_to_nodes.h"
#include "shell/facet_grid.h"
#include "shell/merged_contact.h"
#include "shell/shell_model.h"

#include <optional>
#include <vector>

namespace encased_column {

/// Motion of the sleeve's surface at a contact.
struct SurfaceMotion {
  Vec3 velocity = Vec3::Zero();  ///< [m/s]
  Vec3 spin = Vec3::Zero();      ///< [rad/s]
};

/// A grain that touches the sleeve, as the contact law sees it.
struct SleeveContact {
  int n;      ///< its place in the list
  int grain;  ///< its number
  const MergedContact& merged;
  SurfaceMotion surface;  ///< the motion on which shear force and moment do their work
};

/// What the contact law answers.
struct SleeveReaction {
  double normal_force;  ///< [N]
  Vec3 force;           ///< on the grain [N]
  Vec3 moment;          ///< on the sleeve [N m]
  double stiffness;     ///< larger one of the contact's springs [N/m]
};

/// A grain whose center lies behind the facet it is deepest in.
struct GrainBehind {
  int grain, facet;
};

/// Contacts of grains with a sleeve: which facets are near each grain, how a grain and they
/// overlap, and how the contact force reaches the nodes.
class SleeveContacts {
 public:
  /// Lists, for `grains` centers [m] in a row of triples, the facets within radius + 1.5 `margin`
  /// [m]. The list holds while no grain moves further than the margin and no node than half of it.
  /// What is listed is looked at again only where grain and sleeve may have closed the gap between
  /// them since they were looked at.
  void list(const ShellModel& model, const double* centers, const double* radii, int grains,
            double margin);
  /// True once a node has moved more than half the margin since list().
  bool is_stale(const ShellModel& model) const;
  /// Listed grains, in the order of their numbers.
  const std::vector<int>& grains() const { return grain_; }

  /// For each listed grain that touches, asks `law`, a SleeveReaction of a SleeveContact, and gives
  /// the sleeve what it feels: the normal force along the facets' directions, shear force and
  /// moment at the contact; nodal forces are statically equivalent. Grains tells `centers`, `radii`
  /// and whether a grain `counts(i)`. A sleeve that stands still takes no load: `moves` is false.
  /// With `bound`, adds to it what each contact adds to the stiffness of its nodes. Ends at the
  /// first grain that is behind the sleeve.
  template <typename Grains, typename Law>
  std::optional<GrainBehind> resolve(ShellModel& model, bool moves, const Grains& grains,
                                     std::vector<StiffnessBound>* bound, const Law& law)
  {
    if (grain_.empty()) return {};
    for (int n = 0; n < static_cast<int>(grain_.size()); ++n) {
      const int i = grain_[n];
      const double radius = grains.radii[i];
      const Vec3 center = as_vec3(grains.centers + 3 * i);
      if (!grains.counts(i) || !touches(model, near_[n], center, radius)) continue;
      if (is_behind(model)) return GrainBehind{i, facets_.front().facet};
      SleeveContact contact{n, i, merged_, {}};
      if (moves) {
        take_point(model, center + contact_arm(radius, merged_.overlap) * merged_.normal);
        contact.surface = surface_motion(model);
      }
      const SleeveReaction reaction = law(contact);
      const Vec3 shear = -reaction.force - reaction.normal_force * merged_.normal;
      if (moves) press(model, reaction.normal_force, shear, reaction.moment);
      if (bound) add_stiffness(model, reaction.stiffness, *bound);
    }
    return {};
  }

 private:
  /// A grain near the sleeve, and where all was when the gaps to its facets were found.
  struct Near {
    int grain, begin, end;  ///< its number; its facets in the list
    double clear;           ///< smallest of its gaps [m]
    Vec3 center;
    double radius, travel;  ///< its own [m]; of the sleeve, ShellModel::travel()

    /// By how much all gaps of then may have closed by motion and growth [m].
    double closed(const ShellModel& model, const Vec3& center_now, double radius_now) const
    {
      return (center_now - center).norm() + (model.travel() - travel) + (radius_now - radius);
    }
  };

  bool touches(const ShellModel& model, Near& near, const Vec3& center, double radius);
  bool is_behind(const ShellModel& model) const;
  void take_point(const ShellModel& model, const Vec3& point);
  SurfaceMotion surface_motion(const ShellModel& model) const;
  void press(ShellModel& model, double normal_force, const Vec3& shear, const Vec3& moment) const;
  void add_stiffness(const ShellModel& model, double stiffness,
                     std::vector<StiffnessBound>& bound) const;

  FacetGrid grid_;
  double margin_ = 0.0, listed_travel_ = 0.0;
  std::vector<Vec3> listed_position_;
  std::vector<int> grain_;
  std::vector<Near> near_;   ///< of each grain
  std::vector<int> facet_;   ///< of all grains, those of a grain in a row
  std::vector<double> gap_;  ///< of each, between it and its grain [m]
  // Of the contact at hand:
  std::vector<FacetTouch> facets_;
  std::vector<FacetLever> levers_;
  MergedContact merged_{};
};

}  // namespace encased_column
