// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/rotation.h"
#include "shell/shell_element.h"

#include <random>

namespace encased_column {

/// Vectors with components in (-1, 1), the same in every run.
class RandomVectors {
 public:
  explicit RandomVectors(unsigned seed) : generator_(seed) {}
  Vec3 operator()() { return {uniform_(generator_), uniform_(generator_), uniform_(generator_)}; }

 private:
  std::mt19937 generator_;
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

inline ShellConstants isotropic_shell()
{
  ShellConstants c;
  c.modulus_hoop = 1e6;
  c.poisson = 0.3;
  c.thickness = 0.1;
  c.density = 1000.0;
  return c;
}

inline ShellConstants orthotropic_shell()
{
  ShellConstants c = isotropic_shell();
  c.modulus_axial = 2.5e5;
  c.shear_modulus = 1.2e5;
  return c;
}

inline ShellConstants wrinkling_shell()
{
  ShellConstants c = isotropic_shell();
  c.tension_only = true;
  return c;
}

inline ShellConstants wrinkling_orthotropic_shell()
{
  ShellConstants c = orthotropic_shell();
  c.tension_only = true;
  return c;
}

/// A distorted triangle that lies along no axis.
inline FacetVectors skew_triangle()
{
  return {Vec3(0.2, -0.1, 0.4), Vec3(1.2, 0.1, 0.6), Vec3(0.5, 0.9, 0.2)};
}

/// A facet strained, bent and turned at will.
struct DeformedFacet {
  FacetVectors x;
  std::array<Quaternion, 3> q;

  FacetRotations matrices() const
  {
    return {q[0].toRotationMatrix(), q[1].toRotationMatrix(), q[2].toRotationMatrix()};
  }
};

inline DeformedFacet deformed(const FacetVectors& reference, double strain, double bend,
                              const Vec3& turn, unsigned seed)
{
  RandomVectors random(seed);
  const Quaternion whole = rotation_from_vector(turn);
  DeformedFacet out;
  for (int i = 0; i < 3; ++i) {
    out.x[i] = whole * (reference[i] + strain * random());
    out.q[i] = whole * rotation_from_vector(bend * random());
  }
  return out;
}

}  // namespace encased_column
