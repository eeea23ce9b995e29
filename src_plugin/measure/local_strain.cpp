// SPDX-License-Identifier: GPL-2.0-only
#include "measure/local_strain.h"

#include "contact/grain_grid.h"

#include <Eigen/Dense>

#include <cmath>

namespace encased_column {

namespace {

/// A neighbourhood is flat when the product of its second moments in the principal directions is
/// smaller than this part of their mean cubed.
constexpr double flattest = 1e-2;

/// Weighted sums about the grain in the middle.
struct Neighbourhood {
  double weight = 0.0;
  Vec3 x = Vec3::Zero(), u = Vec3::Zero();
  Mat3 xx = Mat3::Zero(), ux = Mat3::Zero();

  void add(double w, const Vec3& apart, const Vec3& moved)
  {
    const Vec3 weighted = w * apart;
    weight += w;
    x += weighted;
    u += w * moved;
    xx += apart * weighted.transpose();
    ux += moved * weighted.transpose();
  }
};

double deviatoric_part_of_stretch(const Mat3& gradient)
{
  const Mat3 f = Mat3::Identity() + gradient;
  const Eigen::SelfAdjointEigenSolver<Mat3> squares(f.transpose() * f, Eigen::EigenvaluesOnly);
  const Vec3 stretch = squares.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const Vec3 deviator = stretch - Vec3::Constant(stretch.mean());
  return std::sqrt(2.0 / 3.0) * deviator.norm();
}

double deviatoric_strain(const Neighbourhood& n)
{
  if (n.weight == 0.0) return strain_unknown;
  const Mat3 spread = n.xx - n.x * n.x.transpose() / n.weight;
  const Mat3 motion = n.ux - n.u * n.x.transpose() / n.weight;
  if (!(spread.determinant() > flattest * std::pow(spread.trace() / 3.0, 3))) return strain_unknown;
  return deviatoric_part_of_stretch(motion * spread.inverse());
}

}  // namespace

std::vector<double> local_deviatoric_strain(const std::vector<MovedGrain>& grains, double range,
                                            const PeriodicBox& box)
{
  const double finest = finest_neighbour * mean_diameter_by_volume(grains);
  std::vector<MovedGrain> coarse;
  std::vector<double> centers;
  const Vec3 margin = Vec3::Constant(range), from = box.low - margin,
             to = box.low + box.length + margin;
  for (const MovedGrain& grain : grains) {
    if (grain.diameter < finest) continue;
    box.for_images(grain.position, from, to, [&](const Vec3& shift) {
      MovedGrain image = grain;
      image.position += shift;
      centers.insert(centers.end(), image.position.data(), image.position.data() + 3);
      coarse.push_back(image);
    });
  }
  const double reach = 0.5 * range;  // of each of two, as the grid looks for spheres that touch
  GrainGrid grid;
  grid.sort(centers.data(), std::vector<double>(coarse.size(), reach).data(),
            static_cast<int>(coarse.size()));

  std::vector<double> strain;
  for (const MovedGrain& grain : grains) {
    Neighbourhood around;
    const Vec3 position = box.wrapped(grain.position);
    grid.near(position, reach, 0, [&](int j) {
      const MovedGrain& other = coarse[j];
      around.add(std::pow(other.diameter, 3), other.position - position,
                 other.displacement - grain.displacement);
    });
    strain.push_back(deviatoric_strain(around));
  }
  return strain;
}

double mean_diameter_by_volume(const std::vector<MovedGrain>& grains)
{
  double cubes = 0.0, fourths = 0.0;
  for (const MovedGrain& grain : grains) {
    const double cube = std::pow(grain.diameter, 3);
    cubes += cube;
    fourths += cube * grain.diameter;
  }
  return cubes > 0.0 ? fourths / cubes : 0.0;
}

}  // namespace encased_column
