// SPDX-License-Identifier: GPL-2.0-only
// What a cloth costs beside an elastic sleeve: loads of the facets of one mesh, in turns, by state.
// By hand:
//
//   build/bin/bench_facets
#include "shell/cylinder_mesh.h"
#include "shell/shell_model.h"
#include "thread_time.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

using namespace encased_column;

namespace {

ShellConstants constants_of(const std::string& kind)
{
  ShellConstants c;
  c.thickness = 0.01;
  c.modulus_hoop = 11.5e6;
  c.poisson = 0.3;
  c.bending_thickness = 0.001;
  c.density = 30.0;
  c.tension_only = kind != "elastic";
  if (kind.find("two") == 0) {
    c.modulus_axial = 6e6;
    c.shear_modulus = 0.8e6;
    c.poisson = 0.1;
  }
  if (kind.find("strip") == std::string::npos) return c;
  const double axial = kind.find("two") == 0 ? 60e3 : 115e3;
  c.cloth.strip[0] = {{0.0, 0.0}, {0.02, 2300.0}, {0.06, 4300.0}, {0.10, 5100.0}};
  c.cloth.strip[1] = {
      {0.0, 0.0}, {0.02, 0.02 * axial}, {0.06, 0.035 * axial}, {0.10, 0.042 * axial}};
  return c;
}

ShellModel model_in(const std::string& kind, const std::string& state)
{
  ShellModel model(cylinder_mesh(TubeShape{0.05, 0.0, 0.2, 0.005}), constants_of(kind),
                   Vec3::UnitZ());
  double hoop = 0.01, axial = 0.01, shear = 0.0;
  if (state == "wrinkled") hoop = 0.015, axial = -0.03, shear = 0.004;
  if (state == "slack") hoop = -0.01, axial = -0.01;
  if (state == "yielding") hoop = 0.03, axial = -0.03, shear = 0.004;
  std::vector<Vec3> x = model.position();
  for (Vec3& p : x) {
    const double turn = shear * p.z() / 0.05, c = std::cos(turn), s = std::sin(turn);
    p = Vec3((1.0 + hoop) * (p.x() * c - p.y() * s), (1.0 + hoop) * (p.x() * s + p.y() * c),
             (1.0 + axial) * p.z());
  }
  model.set_state(x, model.rotation(), model.velocity(), model.angular_velocity());
  return model;
}

double nanoseconds(ShellModel& model)
{
  const double before = thread_time();
  model.clear_loads();
  model.add_internal_loads(0, model.facets());
  return (thread_time() - before) / model.facets();
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main()
{
  for (const std::string kind : {"wrinkles", "strip", "two", "two_strip"})
    for (const std::string state : {"taut", "wrinkled", "slack", "yielding"}) {
      const bool yielding = state == "yielding";
      if (yielding && kind.find("strip") == std::string::npos) continue;
      ShellModel elastic = model_in("elastic", state), cloth = model_in(kind, state);
      std::vector<Vec3> x = cloth.position();
      std::vector<double> of_elastic, of_cloth, ratio;
      for (int turn = 0; turn < 101; ++turn) {
        if (yielding)  // on and on
          for (Vec3& p : x) p.head<2>() *= 1.00001;
        for (ShellModel* model : {&elastic, &cloth})
          model->set_state(x, model->rotation(), model->velocity(), model->angular_velocity());
        of_elastic.push_back(nanoseconds(elastic));
        of_cloth.push_back(nanoseconds(cloth));
        ratio.push_back(of_cloth.back() / of_elastic.back());
      }
      std::printf("%-9s %-9s elastic %5.1f ns, cloth %5.1f ns a facet, ratio %.2f\n", kind.c_str(),
                  state.c_str(), median(of_elastic), median(of_cloth), median(ratio));
    }
}
