// SPDX-License-Identifier: GPL-2.0-only
// Time of a step of an encased test on up to 1 024 ranks, projected from measured parts. In the
// tree's folder:
//
//   g++ -std=c++17 -O2 -Isrc_plugin -Itests tests/bench/projection.cpp -o projection   (no build
//   needed)
//   ./projection tests/bench/projection.csv > projection_table.csv
#include "bench/step_model.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

using namespace encased_column;

namespace {

struct Part {
  const char* name;
  double StepParts::*value;
};

constexpr Part parts_of_file[] = {
    {"contact", &StepParts::contact},
    {"contacts_per_grain", &StepParts::contacts_per_grain},
    {"grain", &StepParts::grain},
    {"list", &StepParts::list},
    {"facet", &StepParts::facet},
    {"sleeve_contact", &StepParts::sleeve_contact},
    {"sleeve_list", &StepParts::sleeve_list},
    {"step", &StepParts::step},
    {"node", &StepParts::node},
    {"facet_list", &StepParts::facet_list},
    {"list_every", &StepParts::list_every},
    {"ghost", &StepParts::ghost},
    {"ghost_bytes", &StepParts::ghost_bytes},
    {"node_bytes", &StepParts::node_bytes},
    {"small_sums", &StepParts::small_sums},
    {"latency", &StepParts::latency},
    {"bandwidth", &StepParts::bandwidth},
    {"add", &StepParts::add},
    {"grains_per_volume", &StepParts::grains_per_volume},
    {"facet_area", &StepParts::facet_area},
    {"ghost_layer", &StepParts::ghost_layer},
    {"ghost_reach", &StepParts::ghost_reach},
    {"crossing", &StepParts::crossing},
    {"fullest", &StepParts::fullest},
};

/// Rows of name, value, unit, source.
StepParts read_parts(const char* file)
{
  std::map<std::string, double> found;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream cells(line);
    std::string name, value;
    std::getline(cells, name, ',');
    std::getline(cells, value, ',');
    char* end = nullptr;
    const double x = std::strtod(value.c_str(), &end);
    if (!value.empty() && *end == '\0') found[name] = x;
  }
  StepParts parts;
  for (const Part& part : parts_of_file) {
    if (!found.count(part.name)) {
      std::fprintf(stderr, "projection: '%s' must have a row '%s,VALUE,UNIT,SOURCE'\n", file,
                   part.name);
      std::exit(1);
    }
    parts.*part.value = found[part.name];
  }
  return parts;
}

/// The largest of what ranks do not divide.
const char* limit_of(const StepTime& t)
{
  const std::pair<double, const char*> costs[] = {{t.ghosts, "ghosts"},
                                                  {t.small_sums, "small sums"},
                                                  {t.sleeve_nodes, "sleeve's nodes"},
                                                  {t.sleeve_sum, "sleeve's sum"}};
  return std::max_element(std::begin(costs), std::end(costs))->second;
}

}  // namespace

int main(int count, char** word)
{
  if (count != 2) {
    std::fprintf(stderr, "projection: write the file of parts, tests/bench/projection.csv\n");
    return 1;
  }
  const StepParts parts = read_parts(word[1]);
  std::printf(
      "grains,ranks,grains a rank,ghosts a rank,grains [ms],lists [ms],ghosts [ms],small sums "
      "[ms],sleeve divided [ms],sleeve's nodes [ms],sleeve's sum [ms],step "
      "[ms],speed-up,efficiency,"
      "largest of what is not divided\n");
  for (const double grains : {54e3, 1e6, 10e6}) {
    const double alone = time_of_step(grains, 1, parts).all();
    for (int ranks = 1; ranks <= 1024; ranks *= 2) {
      const StepTime t = time_of_step(grains, ranks, parts);
      const double ghosts = CutSpecimen(grains, ranks, parts).ghosts(parts);
      std::printf("%.0f,%d,%.0f,%.0f,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g,%.3g,%.2f,%s\n",
                  grains, ranks, grains / ranks, ghosts, 1e3 * t.grains, 1e3 * t.lists,
                  1e3 * t.ghosts, 1e3 * t.small_sums, 1e3 * t.sleeve, 1e3 * t.sleeve_nodes,
                  1e3 * t.sleeve_sum, 1e3 * t.all(), alone / t.all(), alone / t.all() / ranks,
                  ranks == 1 ? "-" : limit_of(t));
    }
  }
}
