// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/input_error.h"
#include "core/vec3.h"
#include "shell/cloth.h"

namespace encased_column {

/// Elastic constants of the sleeve as a user gives them.
struct ShellConstants {
  double modulus_hoop = 0.0;        ///< E, or E_hoop [Pa]
  double modulus_axial = 0.0;       ///< E_axial [Pa]; 0: isotropic
  double poisson = 0.0;             ///< contraction along the axis under hoop tension [-]
  double shear_modulus = 0.0;       ///< G [Pa], read only when orthotropic
  double thickness = 0.0;           ///< t [m]
  double bending_thickness = -1.0;  ///< t_b [m]; below 0: t; 0: no bending stiffness
  double density = 0.0;             ///< [kg/m^3]
  bool tension_only = false;        ///< the membrane wrinkles instead of carrying compression
  ClothConstants cloth;             ///< strip tests and strength
};

/// Plane-stress law of the sleeve in the axes (hoop, axial): N = t D e, M = t_b^3 / 12 D k; as a
/// cloth the membrane wrinkles, yields and tears.
class ShellMaterial {
 public:
  /// Throws InputError for constants without a positive energy.
  explicit ShellMaterial(const ShellConstants& c) : constants_(c)
  {
    const bool orthotropic = c.modulus_axial > 0.0;
    if (constants_.bending_thickness < 0.0) constants_.bending_thickness = c.thickness;
    require(c.modulus_hoop > 0.0, "modulus of the shell must be larger than 0", c.modulus_hoop,
            "the Young's modulus in Pa");
    require(c.thickness > 0.0, "thickness of the shell must be larger than 0", c.thickness,
            "the thickness in m");
    require(c.density > 0.0, "density of the shell must be larger than 0", c.density,
            "the density in kg/m3");
    const double axial = orthotropic ? c.modulus_axial : c.modulus_hoop;
    if (orthotropic) {
      require(c.poisson * c.poisson < c.modulus_hoop / axial,
              "poisson of an orthotropic shell must be smaller than sqrt(E_hoop / E_axial)",
              c.poisson, "a smaller ratio");
      require(c.shear_modulus > 0.0, "shear_modulus of an orthotropic shell must be larger than 0",
              c.shear_modulus, "the shear modulus in Pa");
    } else {
      require(c.poisson > -1.0 && c.poisson < 0.5, "poisson of the shell must lie in (-1, 0.5)",
              c.poisson, "for instance 0.3");
    }
    const double ratio = axial / c.modulus_hoop;
    const double across = 1.0 / (1.0 - c.poisson * c.poisson * ratio);
    const double shear = orthotropic ? c.shear_modulus : c.modulus_hoop / (2.0 * (1.0 + c.poisson));
    Mat3 d;
    d << c.modulus_hoop * across, c.poisson * axial * across, 0.0,  //
        c.poisson * axial * across, axial * across, 0.0,            //
        0.0, 0.0, shear;
    membrane_ = c.thickness * d;
    const double tb = constants_.bending_thickness;
    bending_ = tb * tb * tb / 12.0 * d;
    cloth_ = Cloth(c.cloth, {c.thickness * c.modulus_hoop, c.thickness * axial}, c.poisson,
                   c.thickness * shear);
  }

  const ShellConstants& constants() const { return constants_; }
  bool bends() const { return constants_.bending_thickness > 0.0; }
  /// t D [N/m]
  const Mat3& membrane() const { return membrane_; }
  /// t_b^3 D / 12 [N m]
  const Mat3& bending() const { return bending_; }

  const Cloth& cloth() const { return cloth_; }
  /// False where the membrane is linear elastic, whatever happens to it.
  bool is_cloth() const { return constants_.tension_only || cloth_.yields(); }

  /// Membrane forces (N11, N22, N12) per reference length [N/m].
  PlaneVector membrane_force(const PlaneVector& strain, const FacetMemory& memory = {}) const
  {
    if (!is_cloth()) return membrane_ * strain;
    const EvenStiffness& even = cloth_.whole();
    const PlaneVector elastic = elastic_strain(strain, memory);
    const bool softens = cloth_.softens_off_axis();
    if (constants_.tension_only)
      return memory.left() * (softens ? relaxed_force<true, true>(even, elastic)
                                      : relaxed_force<true, false>(even, elastic));
    return memory.left() * (softens ? relaxed_force<false, true>(even, elastic)
                                    : relaxed_force<false, false>(even, elastic));
  }

  /// The part of a strain that unloading gives back.
  static PlaneVector elastic_strain(const PlaneVector& strain, const FacetMemory& memory)
  {
    return {strain(0) - memory.plastic_strain[0], strain(1) - memory.plastic_strain[1],
            strain(2) - memory.slip};
  }

  /// Energy stored per reference area [J/m^2], of which the force is the derivative: the force is
  /// linear homogeneous in the elastic strain in every state, wrinkled or not.
  static double membrane_energy(const PlaneVector& elastic_strain, const PlaneVector& force)
  {
    return 0.5 * elastic_strain.dot(force);
  }

 private:
  static void require(bool holds, const char* rule, double found, const char* advice)
  {
    if (!holds)
      throw InputError(std::string(rule) + ", found " + in_words(found) + ": write " + advice);
  }

  ShellConstants constants_;
  Mat3 membrane_, bending_;
  Cloth cloth_;
};

}  // namespace encased_column
