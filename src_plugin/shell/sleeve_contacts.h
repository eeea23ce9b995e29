#pragma once

#include "shell/contact_to_nodes.h"
#include "shell/facet_grid.h"
#include "shell/shell_model.h"
#include "shell/smooth_overlap.h"

#include <vector>

namespace encased_column {

/// Motion of the sleeve's surface at a contact.
struct SurfaceMotion {
  Vec3 velocity;  ///< [m/s]
  Vec3 spin;      ///< [rad/s]
};

/// Contacts of grains with a sleeve: which facets are near each grain, how a grain and they
/// overlap, and how the contact force reaches the nodes.
class SleeveContacts {
 public:
  /// Lists, for `grains` centers [m] in a row of triples, the facets within radius + 1.5 `margin`
  /// [m]. The list holds while no grain moves further than the margin and no node than half of it.
  void list(const ShellModel& model, const double* centers, const double* radii, int grains,
            double margin);
  /// True once a node has moved more than half the margin since list().
  bool is_stale(const ShellModel& model) const;

  /// Listed grains, in the order of their numbers.
  int size() const { return static_cast<int>(grain_.size()); }
  int grain(int n) const { return grain_[n]; }
  const std::vector<int>& grains() const { return grain_; }

  /// Before touches(), where nodes have moved since list().
  void look_at(const ShellModel& model);
  /// Looks whether listed grain n, now at `center` [m], touches. The touch stays with this object
  /// until the next call, for those below.
  bool touches(const ShellModel& model, int n, const Vec3& center, double radius);
  const SmoothTouch& touch() const { return touch_; }
  /// True where the center lies behind the facet it is deepest in.
  bool is_behind(const ShellModel& model) const;
  /// A facet of the touch.
  int facet() const { return facets_.front().facet; }
  /// Takes `point` [m] as the place of the contact, for the two calls below.
  void take_point(const ShellModel& model, const Vec3& point);
  /// How the surface moves there: the motion on which shear force and moment of press() do their
  /// work.
  SurfaceMotion surface_motion(const ShellModel& model) const;
  /// Gives the sleeve what it feels of the touch: the normal force [N] along the facets'
  /// directions, and there the shear force [N] and the moment [N m]. Nodal forces are statically
  /// equivalent.
  void press(ShellModel& model, double normal_force, const Vec3& shear, const Vec3& moment) const;

  /// Adds to `bound` what a contact of this stiffness [N/m] adds to its nodes: 2 k w for the node
  /// of weight w, so that the bounds of a node, with the grain on the other side, stay above the
  /// largest eigenvalue.
  void add_stiffness(const ShellModel& model, double stiffness,
                     std::vector<StiffnessBound>& bound) const;

 private:
  /// Of a facet: points p on it have normal . p = offset.
  struct Plane {
    Vec3 normal;            ///< of any length
    double offset, square;  ///< length squared
  };

  FacetGrid grid_;
  std::vector<Plane> planes_;
  double margin_ = 0.0;
  std::vector<Vec3> listed_position_;
  std::vector<int> grain_, begin_, near_;
  std::vector<FacetTouch> facets_;
  std::vector<FacetLever> levers_;  ///< of the same facets
  SmoothTouch touch_{};
};

}  // namespace encased_column
