// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "packing/gradation.h"

namespace encased_column {

/// What decides how long a case takes and how much it writes.
struct CaseShape {
  Gradation gradation;  ///< of the grains that are packed
  ClassDistribution distribution = ClassDistribution::log_uniform;
  double radius = 0.0, height = 0.0;  ///< of the specimen [m]
  double porosity = 0.0;              ///< it is packed with [-]
  double facets = 0.0;                ///< of a sleeve that deforms; 0: none
  bool friction_packing = false;      ///< friction acts while the packing grows
  bool growth_minds_stress = false;   ///< growth waits while grains press too hard
  bool platens_follow = false;        ///< a servo brings the platens to sigma3
  bool preload = false;
  double limit = 1e-5;                  ///< unbalanced force ratio before shear [-]
  double strain_end = 0.0, rate = 0.0;  ///< axial strain of shear [-], its speed [m per step]
  double frames = 20.0;                 ///< pictures
};

/// The case's size before it is run. Steps of shear follow from its rate; those of the other stages
/// are typical ones, since they end where a ratio of forces has fallen.
struct CaseSize {
  double grains = 0.0;
  double steps_before = 0.0;  ///< of growth and rest, the sleeve rigid
  double steps_after = 0.0;   ///< of preload, consolidation and shear
  double work = 0.0;          ///< [grain-steps], what a sleeve takes counted as grains
  double bytes = 0.0;         ///< on disk at the end
  double steps() const { return steps_before + steps_after; }
};
CaseSize case_size(const CaseShape& shape);

}  // namespace encased_column
