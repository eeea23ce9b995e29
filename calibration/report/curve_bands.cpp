// SPDX-License-Identifier: GPL-2.0-only
#include "report/curve_bands.h"

#include "analysis/sampled_curve.h"
#include "surrogate/polynomial.h"

#include <cmath>
#include <limits>

namespace encased_column {

namespace {

constexpr int strains = 21;
constexpr Eigen::Index fewest = 10, posterior_points = 200;

struct CaseCurves {
  std::vector<SampledCurve> curves;
  std::vector<int> ids;
  double last = std::numeric_limits<double>::infinity();
};

CaseCurves curves_of(const std::string& name, const Findings& found)
{
  CaseCurves all;
  for (const auto& [key, result] : found.runs) {
    if (key.name != name || !result.good() || result.strain.size() < 2) continue;
    all.curves.emplace_back(result.strain, result.stress);
    all.ids.push_back(key.point);
    all.last = std::min(all.last, result.strain.back());
  }
  return all;
}

void add_band(CurveBand& band, const CaseCurves& all, const Findings& found)
{
  const auto rows = static_cast<Eigen::Index>(all.curves.size());
  Data data{Eigen::MatrixXd(rows, found.table.points.cols()), Eigen::VectorXd(rows), all.ids};
  for (Eigen::Index row = 0; row < rows; ++row)
    data.points.row(row) =
        found.points[static_cast<std::size_t>(all.ids[static_cast<std::size_t>(row)])]
            .point.transpose();
  const Eigen::MatrixXd& posterior = found.posterior.points;
  const Eigen::Index every = std::max<Eigen::Index>(1, posterior.rows() / posterior_points);
  for (int n = 0; n < strains; ++n) {
    const double strain = all.last * n / (strains - 1);
    for (Eigen::Index row = 0; row < rows; ++row)
      data.values[row] = all.curves[static_cast<std::size_t>(row)].value(strain);
    const Polynomial polynomial = fit_polynomial(data);
    double sum = 0.0, square = 0.0, count = 0.0;
    for (Eigen::Index row = 0; row < posterior.rows(); row += every, count += 1.0) {
      const double value = polynomial.value(posterior.row(row).transpose());
      sum += value;
      square += value * value;
    }
    const double mean = sum / count;
    const double deviation = std::sqrt(std::max(square / count - mean * mean, 0.0));
    const double wide =
        std::hypot(deviation, pooled_scatter(data.values, data.groups)) / deviation_of_interval;
    band.strain.push_back(strain);
    band.low.push_back(mean - wide);
    band.high.push_back(mean + wide);
  }
}

}  // namespace

std::vector<CurveBand> curve_bands(const CalibrationConfig& config, const Findings& found)
{
  std::vector<CurveBand> bands;
  for (const std::string& name : config.runs.cases) {
    CurveBand band;
    band.name = name;
    const CaseCurves all = curves_of(name, found);
    if (static_cast<Eigen::Index>(all.curves.size()) >= fewest) add_band(band, all, found);
    for (const auto& [key, result] : found.runs)
      if (key.name == name && key.point == found.best && result.good())
        band.best.emplace_back(result.strain, result.stress);
    for (const Target& target : config.targets)
      if (target.quantity == "curve" && target.cases.front() == name) {
        band.laboratory_strain = target.whole_strain;
        band.laboratory_stress = target.whole_stress;
      }
    bands.push_back(std::move(band));
  }
  return bands;
}

}  // namespace encased_column
