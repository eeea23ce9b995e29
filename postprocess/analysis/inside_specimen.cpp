// SPDX-License-Identifier: GPL-2.0-only
#include "analysis/inside_specimen.h"

#include "core/input_error.h"
#include "files/column_names.h"

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

std::optional<double> level_of_share(const std::string& heading)
{
  const std::string &before = contact_column::share_above, &after = contact_column::level_end;
  const std::size_t around = before.size() + after.size();
  if (heading.size() <= around || heading.compare(0, before.size(), before) != 0 ||
      heading.compare(heading.size() - after.size(), after.size(), after) != 0)
    return std::nullopt;
  return read_number(heading, heading.substr(before.size(), heading.size() - around));
}

}  // namespace encased_column
