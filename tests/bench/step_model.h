// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/constants.h"

#include <algorithm>
#include <cmath>

namespace encased_column {

/// What a step of an encased test is made of, each part measured or assumed: projection.csv says
/// which.
struct StepParts {
  // Divided among the ranks:
  double contact = 0;  ///< contacts of two grains, listed pairs that do not touch in it [s each]
  double contacts_per_grain = 0;  ///< [-]
  double grain = 0;               ///< walls, motion, check of distances [s each]
  double list = 0;                ///< a grain's or ghost's part of a new list of pairs [s]
  double facet = 0;               ///< elements and pressure [s each]
  double sleeve_contact = 0;      ///< finding and pressing the contacts with grains [s each facet]
  double sleeve_list = 0;         ///< listing them [s each facet]
  // Repeated on every rank:
  double step = 0;        ///< what no size changes [s]
  double node = 0;        ///< motion and clearing of a sleeve's node [s each]
  double facet_list = 0;  ///< sorting a facet for a new list [s]
  double list_every = 1;  ///< steps from one list to the next
  // Between ranks:
  double ghost = 0;  ///< packing and unpacking of one [s]
  double ghost_bytes = 0;
  double node_bytes =
      0;  ///< of the loads of a sleeve's node, which ranks that touch it send to all
  double small_sums = 0;  ///< sums of a few numbers over the ranks [a step]
  double latency = 0;     ///< of a message [s]
  double bandwidth = 1;   ///< of a rank [byte/s]
  double add = 0;         ///< adding what another rank sends [s each byte]
  // Geometry:
  double grains_per_volume = 1;  ///< [1/m^3]
  double facet_area = 1;         ///< [m^2]
  double ghost_layer = 0;        ///< beyond a cut, as thick as what the host keeps [m]
  double ghost_reach = 0;        ///< the host asks ranks so far away [m]
  double node_layer = 0;         ///< beyond a cut, where a rank's grains may touch the sleeve [m]
  double crossing = 0;           ///< contacts through a cut, which both sides see to [1/m^2]
  double fullest = 0;            ///< the fullest of ranks with m grains has sqrt(fullest / m) more
};

/// A specimen as tall as two diameters, and how ranks cut it: slices along the axis, quarters of
/// slices from 8 ranks on, which have fewest ghosts (the decks' `processors`).
struct CutSpecimen {
  CutSpecimen(double grains_in_all, int on_ranks, const StepParts& parts)
      : grains(grains_in_all),
        ranks(on_ranks)
  {
    const double volume = grains / parts.grains_per_volume;
    radius = std::cbrt(volume / (4.0 * pi));
    across = ranks > 4 ? 2 : 1;
    along = ranks / (across * across);
    slice = 4.0 * radius / along;
  }

  double facets(const StepParts& parts) const
  {
    return 8.0 * pi * radius * radius / parts.facet_area;
  }
  double nodes(const StepParts& parts) const { return 0.5 * facets(parts); }

  /// Cuts next to a rank in the middle of the column, above and below.
  int ends() const { return std::min(along - 1, 2); }
  double area() const { return pi * radius * radius / (across * across); }  ///< of a rank [m^2]
  double sides() const
  {
    return across > 1 ? 2.0 * radius : 0.0;
  }  ///< of its area, along other ranks [m]

  /// Nodes that a rank in the middle sends: those of its facets, strips all around the sleeve, and
  /// those near its grains, which quarters of slices have elsewhere.
  double touched_nodes(const StepParts& parts) const
  {
    const double layer = ends() * radius * parts.node_layer * 2.0 * pi / (across * across);
    const double own = nodes(parts) / ranks;
    return std::min(nodes(parts), across * own + layer / (2.0 * parts.facet_area));
  }

  /// Ghosts of a rank in the middle: a layer of thickness h about it, within the specimen.
  double ghosts(const StepParts& parts) const
  {
    const double h = parts.ghost_layer;
    const double wide =
        std::min(area() + sides() * h + (across > 1 ? h * h : 0.0), pi * radius * radius);
    const double tall = std::min(slice + ends() * h, 4.0 * radius);
    return parts.grains_per_volume * (wide * tall - area() * slice);
  }
  /// Messages that it sends in a step: thin slices ask beyond their neighbours.
  double messages(const StepParts& parts) const
  {
    const double hops = std::min(std::ceil(parts.ghost_reach / slice), along - 1.0);
    return (along > 1 ? ends() * hops : 0.0) + (across > 1 ? 2.0 : 0.0);
  }
  /// Contacts that it sees to: its own and its half of those through its cuts, at most all twice.
  double contacts(const StepParts& parts) const
  {
    const double own = grains * parts.contacts_per_grain / ranks;
    const double cut = ends() * area() + sides() * slice;
    return own + std::min(own, 0.5 * parts.crossing * cut);
  }

  double grains;
  int ranks, across, along;
  double radius, slice;  ///< of the specimen, and height of a rank's part [m]
};

/// Time of adding `bytes` up over the ranks so that all know the sum [s]: whole in every round, or
/// by parts and gathered, what is faster (Thakur, Rabenseifner and Gropp, Int. J. High Perform.
/// Comput. Appl. 19, 2005).
inline double time_of_sum(double bytes, int ranks, const StepParts& parts)
{
  const double rounds = std::ceil(std::log2(ranks)), others = 1.0 - 1.0 / ranks;
  const double whole = rounds * (parts.latency + bytes * (1.0 / parts.bandwidth + parts.add));
  const double by_parts =
      2.0 * rounds * parts.latency + others * bytes * (2.0 / parts.bandwidth + parts.add);
  return std::min(whole, by_parts);
}

/// Time of making `bytes` of each rank known to all [s]: each round doubles what a rank knows (the
/// same source).
inline double time_of_gather(double bytes, int ranks, const StepParts& parts)
{
  return std::ceil(std::log2(ranks)) * parts.latency + (ranks - 1) * bytes / parts.bandwidth;
}

/// Time of a step on the fullest rank, by what it is spent on [s].
struct StepTime {
  double grains;        ///< contacts, motion and walls
  double lists;         ///< of pairs
  double ghosts;        ///< packing, messages
  double small_sums;    ///< over the ranks
  double sleeve;        ///< what ranks divide of it
  double sleeve_nodes;  ///< what every rank repeats
  double sleeve_sum;    ///< of its loads over the ranks
  double all() const
  {
    return grains + lists + ghosts + small_sums + sleeve + sleeve_nodes + sleeve_sum;
  }
};

inline StepTime time_of_step(double grains, int ranks, const StepParts& p)
{
  const CutSpecimen cut(grains, ranks, p);
  const double mean = grains / ranks;
  const double fullest = ranks > 1 ? 1.0 + std::sqrt(p.fullest / mean) : 1.0;
  const double ghosts = cut.ghosts(p), facets = cut.facets(p), nodes = cut.nodes(p);
  StepTime time{};
  time.grains = p.step + fullest * (cut.contacts(p) * p.contact + mean * p.grain);
  time.lists = (fullest * mean + ghosts) * p.list / p.list_every;
  time.ghosts = cut.messages(p) * p.latency + ghosts * (p.ghost + p.ghost_bytes / p.bandwidth);
  time.small_sums = p.small_sums * time_of_sum(8.0, ranks, p);
  time.sleeve =
      facets / ranks * (p.facet + fullest * (p.sleeve_contact + p.sleeve_list / p.list_every));
  time.sleeve_nodes = nodes * p.node + facets * p.facet_list / p.list_every;
  if (ranks > 1) {  // of what is touched, or of all: TouchedNodes
    const double touched = cut.touched_nodes(p) * p.node_bytes;
    time.sleeve_sum = ranks * cut.touched_nodes(p) > 2.0 * nodes
                          ? time_of_sum(nodes * p.node_bytes, ranks, p)
                          : time_of_gather(touched, ranks, p) + ranks * touched * p.add;
  }
  return time;
}

}  // namespace encased_column
