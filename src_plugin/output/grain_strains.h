#pragma once

#include "core/periodic_box.h"
#include "files/vtk_grains_writer.h"

#include <vector>

namespace encased_column {

/// Neighbours for the strain, where the deck does not say: near enough to see a band some ten
/// diameters wide, and some tens of load-bearing grains.
constexpr double usual_strain_range = 1.5;  // mean diameters

/// Gives each of `grains` the deviatoric strain about it, of those within `range` [m] where
/// displacements start; a range below zero stands for the usual one.
void find_strains(std::vector<GrainRecord>& grains, double range, const PeriodicBox& box);

}  // namespace encased_column
