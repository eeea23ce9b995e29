#include "measure/local_strain.h"

#include "contact/grain_grid.h"

#include <Eigen/Dense>

#include <cmath>

namespace encased_column {

namespace {

/// A neighbourhood is flat when its second moment in the thinnest direction is smaller than this
/// part of that in the widest.
constexpr double flattest = 1e-6;

/// Weighted sums about the grain in the middle.
struct Neighbourhood {
  double weight = 0.0;
  Vec3 x = Vec3::Zero(), u = Vec3::Zero();
  Mat3 xx = Mat3::Zero(), ux = Mat3::Zero();

  void add(double w, double side, const Vec3& apart, const Vec3& moved, const Mat3& apart_apart,
           const Mat3& moved_apart)
  {
    weight += w;
    x += (w * side) * apart;
    u += (w * side) * moved;
    xx += w * apart_apart;
    ux += w * moved_apart;
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
  const Mat3 spread = n.xx - n.x * n.x.transpose() / n.weight;
  const Mat3 motion = n.ux - n.u * n.x.transpose() / n.weight;
  const Eigen::SelfAdjointEigenSolver<Mat3> moments(spread, Eigen::EigenvaluesOnly);
  if (!(moments.eigenvalues()(0) > flattest * moments.eigenvalues()(2))) return strain_unknown;
  return deviatoric_part_of_stretch(motion * spread.inverse());
}

}  // namespace

std::vector<double> local_deviatoric_strain(const std::vector<MovedGrain>& grains, double range)
{
  const int count = static_cast<int>(grains.size());
  std::vector<double> centers;
  for (const MovedGrain& grain : grains)
    centers.insert(centers.end(), grain.position.data(), grain.position.data() + 3);
  const double reach = 0.5 * range;  // of each of two, as the grid looks for spheres that touch
  GrainGrid grid;
  grid.sort(centers.data(), std::vector<double>(count, reach).data(), count, 1.0, 0.0);

  std::vector<Neighbourhood> around(count);
  for (int i = 0; i < count; ++i) {
    const MovedGrain& one = grains[i];
    around[i].weight += one.volume;  // itself, at no distance
    grid.near(one.position, reach, i + 1, [&](int j) {
      const MovedGrain& other = grains[j];
      const Vec3 apart = other.position - one.position;
      const Vec3 moved = other.displacement - one.displacement;
      const Mat3 apart_apart = apart * apart.transpose(), moved_apart = moved * apart.transpose();
      around[i].add(other.volume, 1.0, apart, moved, apart_apart, moved_apart);
      around[j].add(one.volume, -1.0, apart, moved, apart_apart, moved_apart);
    });
  }
  std::vector<double> strain;
  for (const Neighbourhood& n : around) strain.push_back(deviatoric_strain(n));
  return strain;
}

double mean_diameter_by_volume(const std::vector<double>& diameters)
{
  double cubes = 0.0, fourths = 0.0;
  for (const double d : diameters) {
    cubes += d * d * d;
    fourths += d * d * d * d;
  }
  return cubes > 0.0 ? fourths / cubes : 0.0;
}

}  // namespace encased_column
