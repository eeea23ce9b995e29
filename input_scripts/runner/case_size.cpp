// SPDX-License-Identifier: GPL-2.0-only
#include "runner/case_size.h"

#include "core/constants.h"
#include "packing/draw_diameters.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

namespace {

/// Typical steps until forces balance to `limit`: their ratio begins near 0.1 and falls by decades.
double consolidation_steps(const CaseShape& shape)
{
  const double decades = std::max(std::log10(0.1 / shape.limit), 0.5);
  if (shape.friction_packing || shape.platens_follow) return 8'000.0 + 1'000.0 * decades;
  // Each decade takes longer than the one before (study_column, `paper`).
  return 125.0 * decades * decades * decades;
}

}  // namespace

CaseSize case_size(const CaseShape& shape)
{
  // A facet that deforms, with its contacts, takes as long as two grains do; a rigid one less
  // (encased_050 beside plain_050, `quick`, one rank).
  constexpr double grains_per_facet = 2.0, grains_per_rigid_facet = 0.3;
  // A grain of the tests beside one of speed/packing.lmp (one rank): fewer touch where friction
  // keeps the packing loose (plain_100, `quick`), more without it (speed/packing.lmp at porosity
  // 0.29).
  constexpr double loose_grain = 0.75, dense_grain = 1.6;
  // Bytes in a restart file and in a picture with its contacts, compressed.
  constexpr double restart_bytes = 650.0, restart_files = 6.0, picture_bytes = 110.0;
  constexpr double bytes_of_pages = 8e6;

  CaseSize size;
  const double volume = pi * shape.radius * shape.radius * shape.height;
  size.grains =
      expected_count(shape.gradation, shape.distribution, (1.0 - shape.porosity) * volume);
  size.steps_before = shape.growth_minds_stress ? 20'000.0 : 7'000.0;
  size.steps_after = (shape.preload ? 10'000.0 : 0.0) + consolidation_steps(shape) +
                     shape.strain_end * shape.height / shape.rate;
  const double grain_work = size.grains * (shape.friction_packing ? loose_grain : dense_grain);
  size.work = size.steps_before * (grain_work + grains_per_rigid_facet * shape.facets) +
              size.steps_after * (grain_work + grains_per_facet * shape.facets);
  size.bytes = size.grains * restart_bytes * restart_files +
               (size.grains + shape.facets) * picture_bytes * shape.frames + bytes_of_pages;
  return size;
}

}  // namespace encased_column
