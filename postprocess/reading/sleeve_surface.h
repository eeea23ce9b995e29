#pragma once

#include <array>
#include <filesystem>
#include <vector>

namespace encased_column {

/// How many of `centers` [m] lie behind the sleeve of `file` (.vtp) as seen from the z axis: the
/// straight way to them from the axis, at their own height, goes through a facet. A sleeve that is
/// folded back over itself would count grains before the fold; above and below it none is counted.
/// Throws InputError if `file` holds no facets.
long count_beyond_sleeve(const std::vector<std::array<double, 3>>& centers,
                         const std::filesystem::path& file);

}  // namespace encased_column
