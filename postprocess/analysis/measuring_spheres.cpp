#include "analysis/measuring_spheres.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace encased_column {

std::vector<SphereSeries> sphere_series(const std::vector<double>& sphere,
                                        const std::vector<SphereSample>& rows)
{
  std::map<double, SphereSeries> by_number;
  for (std::size_t row = 0; row < rows.size(); ++row) by_number[sphere[row]].push_back(rows[row]);
  std::vector<SphereSeries> spheres;
  std::size_t samples = rows.size();
  for (auto& [number, series] : by_number) {
    samples = std::min(samples, series.size());
    spheres.push_back(std::move(series));
  }
  for (SphereSeries& series : spheres) series.resize(samples);
  std::stable_sort(spheres.begin(), spheres.end(), [](const auto& a, const auto& b) {
    return a.front().height < b.front().height;
  });
  return spheres;
}

std::vector<double> over_time(const SphereSeries& sphere, double SphereSample::*quantity)
{
  std::vector<double> values;
  for (const SphereSample& sample : sphere) values.push_back(sample.*quantity);
  return values;
}

std::vector<double> along_column(const std::vector<SphereSeries>& spheres, std::size_t i,
                                 double SphereSample::*quantity)
{
  std::vector<double> values;
  for (const SphereSeries& sphere : spheres) values.push_back(sphere[i].*quantity);
  return values;
}

double mean_of_spheres(const std::vector<SphereSeries>& spheres, std::size_t i,
                       double SphereSample::*quantity)
{
  const std::vector<double> values = along_column(spheres, i, quantity);
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace encased_column
