// SPDX-License-Identifier: GPL-2.0-only
#include "shell/surface_mesh.h"

#include "core/input_error.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace encased_column {

namespace {

using Edge = std::pair<int, int>;
using Cell = std::array<long, 3>;

std::string at(const Vec3& x)
{
  return "(" + in_words(x.x()) + ", " + in_words(x.y()) + ", " + in_words(x.z()) + ") m";
}

void require_sound_facets(const SurfaceMesh& mesh)
{
  std::vector<char> used(mesh.node.size(), 0);
  for (std::size_t f = 0; f < mesh.facet.size(); ++f) {
    const Facet& facet = mesh.facet[f];
    const Vec3 side = mesh.node[facet[1]] - mesh.node[facet[0]];
    const Vec3 other = mesh.node[facet[2]] - mesh.node[facet[0]];
    // Also true when a node is named twice: then a side has no length.
    if (!(side.cross(other).norm() > 1e-9 * std::max(side.squaredNorm(), other.squaredNorm())))
      throw InputError("every facet of the mesh needs an area, found facet " + std::to_string(f) +
                       " at " + at(mesh.node[facet[0]]) + " without: remove it from the mesh");
    for (const int i : facet) used[i] = 1;
  }
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i])
      throw InputError("every node of the mesh must belong to a facet, found node " +
                       std::to_string(i) + " at " + at(mesh.node[i]) +
                       " alone: remove it from the mesh");
}

void require_single_facets(const SurfaceMesh& mesh)
{
  std::map<Facet, std::size_t> known;
  for (std::size_t f = 0; f < mesh.facet.size(); ++f) {
    Facet nodes = mesh.facet[f];
    std::sort(nodes.begin(), nodes.end());
    const auto [first, is_new] = known.emplace(nodes, f);
    if (!is_new)
      throw InputError("every facet of the mesh must stand once, found facet " + std::to_string(f) +
                       " at " + at(mesh.node[nodes[0]]) + " at the place of facet " +
                       std::to_string(first->second) + ": remove the double one");
  }
}

}  // namespace

SurfaceMesh welded(const std::vector<std::array<Vec3, 3>>& triangle, double tolerance)
{
  SurfaceMesh mesh;
  std::map<Cell, int> known;
  const auto find = [&](const Vec3& x) {
    // Two corners within the tolerance may fall on either side of a cell's border: search the
    // neighbouring cells too.
    const Cell home{std::lround(x.x() / tolerance), std::lround(x.y() / tolerance),
                    std::lround(x.z() / tolerance)};
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k) {
          const auto seen = known.find({home[0] + i, home[1] + j, home[2] + k});
          if (seen != known.end() &&
              (mesh.node[seen->second] - x).cwiseAbs().maxCoeff() <= tolerance)
            return seen->second;
        }
    known[home] = static_cast<int>(mesh.node.size());
    mesh.node.push_back(x);
    return known[home];
  };
  for (const auto& corner : triangle)
    mesh.facet.push_back({find(corner[0]), find(corner[1]), find(corner[2])});
  return mesh;
}

SurfaceMesh welded(const std::vector<std::array<Vec3, 3>>& triangle)
{
  Vec3 low = triangle.front().front(), high = low;
  for (const auto& corners : triangle)
    for (const Vec3& corner : corners) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  return welded(triangle, 1e-6 * (high - low).maxCoeff());
}

std::vector<std::vector<int>> border_loops(const SurfaceMesh& mesh)
{
  require_sound_facets(mesh);
  require_single_facets(mesh);
  std::map<Edge, int> directed;  // the facet that runs along an edge in this direction
  std::map<Edge, int> sides;     // how many facets share an edge, whichever way
  for (std::size_t f = 0; f < mesh.facet.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const Edge edge{mesh.facet[f][i], mesh.facet[f][(i + 1) % 3]};
      if (++sides[std::minmax(edge.first, edge.second)] > 2)
        throw InputError(
            "an edge of the mesh must join two facets at most, found a third one, "
            "facet " +
            std::to_string(f) + ", at " + at(mesh.node[edge.first]) +
            ": remove what branches off the sleeve");
      if (!directed.emplace(edge, static_cast<int>(f)).second)
        throw InputError("neighbouring facets of the mesh must be oriented alike, found facets " +
                         std::to_string(directed[edge]) + " and " + std::to_string(f) + " at " +
                         at(mesh.node[edge.first]) + " against it: turn the inverted facet round");
    }
  std::multimap<int, int> next;  // along the border
  for (const auto& [edge, facet] : directed)
    if (!directed.count({edge.second, edge.first})) next.emplace(edge.first, edge.second);

  std::vector<std::vector<int>> loops;
  while (!next.empty()) {
    std::vector<int> loop;
    int i = next.begin()->first;
    for (auto step = next.find(i); step != next.end(); step = next.find(i)) {
      loop.push_back(i);
      i = step->second;
      next.erase(step);
    }
    loops.push_back(loop);
  }
  return loops;
}

std::vector<std::array<int, 2>> facet_pairs(const SurfaceMesh& mesh)
{
  std::map<Edge, int> directed;
  for (std::size_t f = 0; f < mesh.facet.size(); ++f)
    for (int i = 0; i < 3; ++i)
      directed[{mesh.facet[f][i], mesh.facet[f][(i + 1) % 3]}] = static_cast<int>(f);
  std::vector<std::array<int, 2>> pairs;
  for (const auto& [edge, facet] : directed) {
    const auto other = directed.find({edge.second, edge.first});
    if (edge.first < edge.second && other != directed.end())
      pairs.push_back({facet, other->second});
  }
  return pairs;
}

void require_sleeve(const SurfaceMesh& mesh)
{
  const auto loops = border_loops(mesh);
  if (loops.size() == 2) return;
  std::string found = "none";
  if (!loops.empty()) {
    // The ends have many edges, a hole few: the shortest border is where to look.
    const std::vector<int>* shortest = &loops.front();
    for (const auto& loop : loops)
      if (loop.size() < shortest->size()) shortest = &loop;
    found = std::to_string(loops.size()) + " (the shortest passes " +
            at(mesh.node[shortest->front()]) + ")";
  }
  throw InputError("the mesh of a sleeve needs exactly two borders, its two ends, found " + found +
                   ": close the holes or open the ends of the mesh");
}

}  // namespace encased_column
