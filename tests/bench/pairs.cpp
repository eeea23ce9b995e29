// SPDX-License-Identifier: GPL-2.0-only
// What the contacts of grains cost with rolling resistance and without, in turns: the law's loop
// over pairs alone, on a packing of packing.lmp. By hand:
//
//   build/bin/bench_pairs packing.data [TURNS] [SPIN]
//
// SPIN [rad/s] of the grains decides how many contacts roll at their limit.
#include "contact/grain_grid.h"
#include "contact/listed_pairs.h"
#include "contact/rolling_batch.h"
#include "contact/touching_pairs.h"
#include "thread_time.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

using namespace encased_column;

namespace {

struct Grains {
  std::vector<double> x, radius, v, omega, force, moment;
};

Grains read(const char* path, double spin)
{
  Grains grains;
  std::ifstream file(path);
  std::string line;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> both(-1.0, 1.0);
  while (std::getline(file, line) && line.compare(0, 10, "Velocities") != 0) {
    std::istringstream words(line);
    double number[10];
    int count = 0;
    while (count < 10 && words >> number[count]) ++count;
    if (count < 10) continue;
    grains.radius.push_back(0.5 * number[2]);
    for (int a = 0; a < 3; ++a) {
      grains.x.push_back(number[4 + a]);
      grains.v.push_back(1e-3 * spin * both(random));
      grains.omega.push_back(spin * both(random));
    }
  }
  grains.force.assign(grains.x.size(), 0.0);
  grains.moment.assign(grains.x.size(), 0.0);
  return grains;
}

/// As PairLinear::press_in_batches().
template <typename Batch>
struct Loop {
  ListedPairs pairs;
  Batch batch;
  long contacts = 0, sliding = 0;
  double loss = 0.0;

  Loop(const Grains& grains, int numbers)
  {
    const int count = static_cast<int>(grains.radius.size());
    GrainGrid grid;
    std::vector<double> wide = grains.radius;
    for (double& radius : wide) radius += 2e-4;
    grid.sort(grains.x.data(), wide.data(), count);
    pairs.start(numbers, 3);
    for (int i = 0; i < count; ++i)
      grid.near(as_vec3(&grains.x[3 * i]), wide[i], i + 1, [&](int j) { pairs.add(i, j); });
    pairs.end();
  }

  void step(Grains& g, const ContactMaterial& material, double dt, double number)
  {
    contacts = sliding = 0;
    int touching[longest_block];
    for (int begin = 0; begin < pairs.size(); begin += longest_block) {
      const int ahead = begin + 8 * longest_block;
      for (int n = ahead; n < std::min(ahead + longest_block, pairs.size()); ++n) {
        const int j = pairs.second()[n];
        __builtin_prefetch(&g.radius[j]);
        for (const double* row : {&g.x[3 * j], &g.v[3 * j], &g.omega[3 * j]})
          __builtin_prefetch(row);
        __builtin_prefetch(&g.force[3 * j], 1);
        __builtin_prefetch(&g.moment[3 * j], 1);
      }
      const int* first = pairs.first() + begin;
      const int* second = pairs.second() + begin;
      const int found =
          find_touching_pairs(g.x.data(), g.radius.data(), first, second,
                              std::min(longest_block, pairs.size() - begin), touching);
      for (int m = 0; m < found; ++m) {
        const int i = first[touching[m]], j = second[touching[m]];
        batch.add(i, j, 1.0, material, as_vec3(&g.x[3 * j]) - as_vec3(&g.x[3 * i]),
                  {g.radius[i], as_vec3(&g.v[3 * i]), as_vec3(&g.omega[3 * i])},
                  {g.radius[j], as_vec3(&g.v[3 * j]), as_vec3(&g.omega[3 * j])}, 0.0,
                  pairs.memory(begin + touching[m]));
        if (batch.is_full()) finish(g, dt, number);
      }
    }
    finish(g, dt, number);
  }

  void finish(Grains& g, double dt, double number)
  {
    loss += batch.resolve(dt, number, true);
    batch.keep(number);
    for (int n = 0; n < batch.count(); ++n) {
      const int i = batch.i(n), j = batch.j(n);
      as_vec3(&g.force[3 * i]) += batch.force(n);
      as_vec3(&g.moment[3 * i]) += batch.moment_i(n);
      as_vec3(&g.force[3 * j]) -= batch.force(n);
      as_vec3(&g.moment[3 * j]) += batch.moment_j(n);
      sliding += batch.is_sliding(n);
    }
    contacts += batch.count();
    batch.clear();
  }
};

}  // namespace

int main(int narg, char** arg)
{
  if (narg < 2) return std::fprintf(stderr, "bench_pairs: name a packing\n"), 1;
  const int turns = narg > 2 ? std::atoi(arg[2]) : 15;
  Grains grains = read(arg[1], narg > 3 ? std::atof(arg[3]) : 0.01);
  const ContactMaterial material{7e6, 3.5, 0.8, 0.0, 0.0, 0.55};
  Loop<ContactBatch> plain(grains, memory_size);
  Loop<RollingBatch> rolling(grains, memory_size_rolling);
  std::vector<double> without, with, ratio;
  double number = 0.0;
  constexpr int steps = 20;
  for (int turn = 0; turn < turns; ++turn) {
    const double first = number, start = thread_time();
    for (int n = 0; n < steps; ++n) plain.step(grains, material, 1e-5, number += 1.0);
    const double middle = thread_time();
    number = first;
    for (int n = 0; n < steps; ++n) rolling.step(grains, material, 1e-5, number += 1.0);
    const double end = thread_time();
    without.push_back((middle - start) / steps / static_cast<double>(plain.contacts));
    with.push_back((end - middle) / steps / static_cast<double>(rolling.contacts));
    ratio.push_back(with.back() - without.back());
  }
  for (auto* row : {&without, &with, &ratio}) {
    std::sort(row->begin(), row->end());
    std::printf("%s: median %.2f ns a contact (%.2f to %.2f)\n",
                row == &without ? "without rolling resistance"
                                : (row == &with ? "with" : "difference in a turn"),
                (*row)[row->size() / 2], row->front(), row->back());
  }
  double sum = 0.0;
  for (double moment : grains.moment) sum += moment * moment;
  std::printf("%ld contacts of %d pairs, sliding %ld; losses %.17g, %.17g, moments %.17g\n",
              rolling.contacts, rolling.pairs.size(), rolling.sliding, plain.loss, rolling.loss,
              sum);
}
