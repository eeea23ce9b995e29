// SPDX-License-Identifier: GPL-2.0-only
// Time of a step of an encased test on up to 1 024 ranks, projected from measured parts. In the
// tree's folder:
//
//   build/bin/bench_projection tests/bench/projection.csv > projection_table.csv
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
    {"node_layer", &StepParts::node_layer},
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

/// NAME=VALUE
void change(StepParts& parts, const std::string& word)
{
  const auto sign = std::min(word.find('='), word.size());
  for (const Part& part : parts_of_file)
    if (word.substr(0, sign) == part.name) {
      parts.*part.value = std::atof(word.c_str() + std::min(sign + 1, word.size()));
      return;
    }
  std::fprintf(stderr, "projection: found '%s', write NAME=VALUE with a name of the file\n",
               word.c_str());
  std::exit(1);
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
  if (count < 2) {
    std::fprintf(stderr, "projection: write the file of parts, tests/bench/projection.csv\n");
    return 1;
  }
  StepParts parts = read_parts(word[1]);
  for (int n = 2; n < count; ++n) change(parts, word[n]);
  std::printf(
      "| grains | ranks | ghosts a rank | contacts, motion, walls | lists | ghosts | small sums | "
      "sleeve, divided | sleeve, repeated | its sum | step [ms] | speed-up | largest of what is "
      "not "
      "divided |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const double grains : {54e3, 1e6, 10e6}) {
    const double alone = time_of_step(grains, 1, parts).all();
    for (const int ranks : {1, 4, 16, 64, 256, 1024}) {
      const StepTime t = time_of_step(grains, ranks, parts);
      const double times[] = {t.grains, t.lists,        t.ghosts,     t.small_sums,
                              t.sleeve, t.sleeve_nodes, t.sleeve_sum, t.all()};
      std::printf("| %.0f | %d | %.0f |", grains, ranks,
                  CutSpecimen(grains, ranks, parts).ghosts(parts));
      for (const double time : times) std::printf(" %.3g |", 1e3 * time);
      std::printf(" %.3g | %s |\n", alone / t.all(), ranks == 1 ? "" : limit_of(t));
    }
  }
}
