#include "contact/coincident_grains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace encased_column {

std::optional<std::pair<int, int>> find_coincident(const double* centers, int count)
{
  struct Grain {
    std::array<double, 3> center;
    int index;
  };
  std::vector<Grain> grains;
  for (int i = 0; i < count; ++i) {
    const double* x = centers + 3 * i;
    // Those that are no numbers have no order.
    if (std::isfinite(x[0] + x[1] + x[2])) grains.push_back({{x[0], x[1], x[2]}, i});
  }
  std::sort(grains.begin(), grains.end(),
            [](const Grain& a, const Grain& b) { return a.center < b.center; });
  const auto same =
      std::adjacent_find(grains.begin(), grains.end(),
                         [](const Grain& a, const Grain& b) { return a.center == b.center; });
  if (same == grains.end()) return {};
  return std::minmax(same->index, (same + 1)->index);
}

}  // namespace encased_column
