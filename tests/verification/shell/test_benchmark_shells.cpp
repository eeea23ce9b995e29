// SPDX-License-Identifier: GPL-2.0-only
#include "static_shell.h"

#include "core/constants.h"
#include "support/shell_oracles.h"

#include <gtest/gtest.h>

#include <cstdio>

using namespace encased_column;

namespace {

/// A published problem: a panel of n x n squares, its load and the displacement that is compared.
struct Benchmark {
  const char* name;
  ShellConstants constants;
  double radius, arc, length;
  bool mirrored_at_far_side;  ///< the side a = arc lies in a plane of symmetry z = 0
  double reference;           ///< of the displacement towards -z
  AddLoads (*loads)(const ShellModel&, double scale);
  double scale;  ///< of the load; the references are geometrically linear
};

ShellConstants constants(double modulus, double poisson, double thickness)
{
  ShellConstants c;
  c.modulus_hoop = modulus;
  c.poisson = poisson;
  c.thickness = thickness;
  c.density = 1.0;
  return c;
}

/// Scordelis and Lo's roof, J. Am. Concr. Inst. 61 (1964) 539-561: dead load, fall of the free
/// edge's middle.
const Benchmark roof{"Scordelis-Lo",
                     constants(4.32e8, 0.0, 0.25),
                     25.0,
                     40.0 * pi / 180.0,
                     25.0,
                     false,
                     0.3024,
                     [](const ShellModel& model, double scale) -> AddLoads {
                       return [area = nodal_areas(model), scale](ShellModel& m) {
                         for (int i = 0; i < m.nodes(); ++i)
                           m.force(i).z() -= scale * 90.0 * area[i];
                       };
                     },
                     1e-3};

/// Pinched cylinder with end diaphragms, an octant; the hundredfold load moves it by a thousandth
/// of the thickness, still linear and further from round-off.
const Benchmark pinched{"pinched cylinder",
                        constants(3e6, 0.3, 3.0),
                        300.0,
                        0.5 * pi,
                        300.0,
                        true,
                        1.8248e-5,
                        [](const ShellModel&, double scale) -> AddLoads {
                          return [scale](ShellModel& m) { m.force(0).z() -= 0.25 * scale; };
                        },
                        100.0};

ShellModel supported(const Benchmark& b, int n)
{
  ShellModel model(cylinder_panel(b.radius, b.arc, b.length, n), b.constants, Vec3::UnitY());
  for (int j = 0; j <= n; ++j) {
    model.support().push_back(in_symmetry_plane((n + 1) * j, Vec3::UnitX()));
    model.support().push_back(in_symmetry_plane(j, Vec3::UnitY()));
    model.support().push_back(held_across(n * (n + 1) + j, Vec3::UnitY()));
    if (b.mirrored_at_far_side)
      model.support().push_back(in_symmetry_plane(n + (n + 1) * j, Vec3::UnitZ()));
  }
  return model;
}

/// `at_16` and `at_32` are the ratios of displacement to reference of this element on these meshes.
void expect_convergence_from_below(const Benchmark& b, double at_16, double at_32)
{
  double last = 0.0;
  for (const int n : {4, 8, 16, 32}) {
    ShellModel model = supported(b, n);
    const int watched = b.mirrored_at_far_side ? 0 : n;
    const AddLoads loads = b.loads(model, b.scale);
    loads(model);
    const double direct = -direct_solution(model)(6 * watched + 2) / (b.scale * b.reference);
    const Relaxation how = relax(model, loads, 1e-4, 200000);
    const double fall = model.reference()[watched].z() - model.position()[watched].z();
    const double ratio = fall / (b.scale * b.reference);
    std::printf("%-17s %2d x %-2d  ratio to reference %.4f, direct solve %.4f, %ld steps\n", b.name,
                n, n, ratio, direct, how.steps);
    EXPECT_LT(how.unbalanced, 1e-4);
    EXPECT_NEAR(ratio, direct, 1e-3);
    EXPECT_GT(ratio, last);
    EXPECT_LT(ratio, 1.0);
    if (n == 16) {
      EXPECT_NEAR(ratio, at_16, 2e-3);
    }
    last = ratio;
  }
  EXPECT_NEAR(last, at_32, 2e-3);
}

}  // namespace

TEST(ShellBenchmark, ScordelisLoRoofConvergesMonotonically)
{
  expect_convergence_from_below(roof, 0.9525, 0.9823);
}

TEST(ShellBenchmark, PinchedCylinderWithDiaphragmsConvergesFromBelow)
{
  expect_convergence_from_below(pinched, 0.9742, 0.9959);
}
