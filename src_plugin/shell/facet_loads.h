// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/corotational_frame.h"
#include "shell/cst_membrane.h"
#include "shell/dkt_bending.h"

#include <array>

namespace encased_column {

/// Three vectors, one per node of a facet.
using FacetVectors = std::array<Vec3, 3>;
using FacetRotations = std::array<Mat3, 3>;

/// What a facet does to its nodes.
struct FacetLoads {
  FacetVectors force;   ///< [N]
  FacetVectors moment;  ///< about the node, global axes [N m]
  double energy;        ///< membrane and bending [J]
};

/// What a membrane answers to a strain.
struct MembraneAnswer {
  PlaneVector elastic_strain;  ///< the part that stores energy [-]
  PlaneVector force;           ///< [N/m]
};

/// What the loads of a facet need of its reference, in material axes.
struct FacetReference {
  Triangle2 gradient;         ///< of the area coordinates, as columns [1/m]
  TiltStiffness bending;      ///< [N m/rad]
  double area;                ///< [m^2]
  double bending_left = 1.0;  ///< of the bending stiffness, less in a torn facet [-]
};

/// The frame of a facet whose nodes are at `x` [m]. The gradients sum to zero, so differences to
/// the first node do; they also keep the digits.
template <typename Reference>
CorotationalFrame frame_at(const Reference& facet, const FacetVectors& x)
{
  const Vec3 a = x[1] - x[0], b = x[2] - x[0];
  return {facet.gradient(0, 1) * a + facet.gradient(0, 2) * b,
          facet.gradient(1, 1) * a + facet.gradient(1, 2) * b};
}

/// Forces, moments and energy at node positions `x` [m] and directors `d` (the facet's reference
/// normal as each node has turned it): minus the exact gradient of the energy stored. `membrane`
/// gives the MembraneAnswer to a strain. Reference is FacetReference or reads like it. Without
/// branches and calls, so that facets fit side by side into vector units.
template <bool bends, typename Reference, typename Membrane>
FacetLoads facet_loads(const Reference& facet, const FacetVectors& x, const FacetVectors& d,
                       const Membrane& membrane)
{
  const CorotationalFrame frame = frame_at(facet, x);
  const MembraneAnswer answer = membrane(membrane_strain(frame));
  const MembranePull pull(frame, answer.force);
  Vec3 p1 = facet.area * pull.p1, p2 = facet.area * pull.p2;

  FacetLoads out;
  out.energy = 0.5 * facet.area * answer.elastic_strain.dot(answer.force);
  if constexpr (bends) {
    const FacetVectors director{frame.to_local(d[0]), frame.to_local(d[1]), frame.to_local(d[2])};
    // The scales of the tilts, 2 / (1 + d3), by one division.
    const double t0 = 1.0 + director[0].z(), t1 = 1.0 + director[1].z(), t2 = 1.0 + director[2].z();
    const double t01 = t0 * t1, twice = 2.0 / (t01 * t2), by_t2 = twice * t2;
    const DirectorTilt tilt[3] = {DirectorTilt(director[0], by_t2 * t1),
                                  DirectorTilt(director[1], by_t2 * t0),
                                  DirectorTilt(director[2], twice * t01)};
    const double tilts[6] = {tilt[0].x, tilt[0].y, tilt[1].x, tilt[1].y, tilt[2].x, tilt[2].y};
    double slope[6];
#pragma GCC unroll 6
    for (int i = 0; i < 6; ++i) {
      slope[i] = facet.bending(i, 0) * tilts[0];
#pragma GCC unroll 5
      for (int j = 1; j < 6; ++j) slope[i] += facet.bending(i, j) * tilts[j];
      slope[i] *= facet.bending_left;
      out.energy += 0.5 * tilts[i] * slope[i];
    }
    const FacetVectors conjugate{tilt[0].work_conjugate(director[0], slope[0], slope[1]),
                                 tilt[1].work_conjugate(director[1], slope[2], slope[3]),
                                 tilt[2].work_conjugate(director[2], slope[4], slope[5])};
    for (int i = 0; i < 3; ++i) out.moment[i] = -frame.to_global(conjugate[i]);
    const Vec3 sum = conjugate[0] + conjugate[1] + conjugate[2];
    // The frame turns with the nodes; its spin about e1, e2 follows from the rise of g1, g2 along
    // e3, its spin about e3 from the polar rotation. The conjugate of that spin is -sum.
    const double inverse = frame.inverse_area, about = frame.inverse_trace * sum.z();
    p1 += inverse * (sum.x() * frame.u12 + sum.y() * frame.u22) * frame.e3 - about * frame.e2;
    p2 -= inverse * (sum.x() * frame.u11 + sum.y() * frame.u12) * frame.e3 - about * frame.e1;
  } else {
    for (Vec3& moment : out.moment) moment = Vec3::Zero();
  }
  for (int i = 1; i < 3; ++i) out.force[i] = -facet.gradient(0, i) * p1 - facet.gradient(1, i) * p2;
  out.force[0] = -(out.force[1] + out.force[2]);
  return out;
}

}  // namespace encased_column
