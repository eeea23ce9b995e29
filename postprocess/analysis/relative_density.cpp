// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/relative_density.h"

#include "analysis/sampled_curve.h"

#include <algorithm>

namespace encased_column {

namespace {

constexpr double last_digit = 5e-4;  // half of the last one of a porosity as printed [-]

double void_ratio(double porosity)
{
  return porosity / (1.0 - porosity);
}

/// Void ratio over relative density, which must rise.
std::optional<SampledCurve> void_ratios(std::vector<DensityPoint>& points)
{
  if (points.size() < 2) return std::nullopt;
  std::sort(points.begin(), points.end(), [](const DensityPoint& a, const DensityPoint& b) {
    return a.relative_density < b.relative_density;
  });
  std::vector<double> density, ratio;
  for (const DensityPoint& point : points) {
    density.push_back(point.relative_density);
    ratio.push_back(void_ratio(point.porosity));
  }
  return SampledCurve(density, ratio);
}

}  // namespace

std::optional<double> relative_density_at(double porosity, std::vector<DensityPoint> points)
{
  const std::optional<SampledCurve> curve = void_ratios(points);
  if (!curve || porosity > points.front().porosity + last_digit ||
      porosity < points.back().porosity - last_digit)
    return std::nullopt;
  // The denser, the smaller the void ratio.
  const double wanted = std::clamp(void_ratio(porosity), curve->y().back(), curve->y().front());
  std::size_t after = 1;
  while (after + 1 < curve->size() && curve->y()[after] > wanted) ++after;
  const double before = curve->y()[after - 1], behind = curve->y()[after];
  const double share = before > behind ? (before - wanted) / (before - behind) : 0.0;
  return curve->x()[after - 1] + share * (curve->x()[after] - curve->x()[after - 1]);
}

std::optional<double> porosity_at(double relative_density, std::vector<DensityPoint> points)
{
  const std::optional<SampledCurve> curve = void_ratios(points);
  if (!curve || relative_density < curve->x().front() - 1e-9 ||
      relative_density > curve->x().back() + 1e-9)
    return std::nullopt;
  const double ratio = curve->value(relative_density);
  return ratio / (1.0 + ratio);
}

}  // namespace encased_column
