// SPDX-License-Identifier: GPL-2.0-only
// What every rank repeats of a sleeve, whatever part of its facets is its own: motion and clearing
// of the nodes in each step, and sorting the facets for a new list. By hand:
//
//   build/bin/bench_nodes
#include "shell/cylinder_mesh.h"
#include "shell/sleeve_contacts.h"
#include "thread_time.h"

#include <algorithm>
#include <cstdio>
#include <vector>

using namespace encased_column;

namespace {

/// Median time of `turns` calls [ns].
template <typename Work>
double time_of(int turns, const Work& work)
{
  std::vector<double> times;
  for (int turn = 0; turn < turns; ++turn) {
    const double before = thread_time();
    work();
    times.push_back(thread_time() - before);
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

}  // namespace

int main()
{
  ShellConstants constants;
  constants.modulus_hoop = 11.5e6;
  constants.thickness = 0.01;
  constants.density = 30.0;
  for (const double size : {1.0, 2.65, 5.71}) {  // 54 000, 1 million and 10 million grains
    ShellModel model(cylinder_mesh(TubeShape{0.05 * size, 0.0, 0.2 * size, 0.005}), constants,
                     Vec3::UnitZ());
    const double step = time_of(301, [&] {
      model.advance(1e-9, 0.2);
      model.clear_loads();
      for (int i = 0; i < model.nodes(); ++i) model.force(i) += model.external()[i];
    });
    SleeveContacts contacts;
    const double list = time_of(51, [&] { contacts.list(model, nullptr, nullptr, 0, 4e-4); });
    std::printf("%d nodes, %d facets: a step %.1f ns a node, a list %.1f ns a facet\n",
                model.nodes(), model.facets(), step / model.nodes(), list / model.facets());
  }
}
