// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace encased_column {

/// What one measuring sphere said at one time.
struct SphereSample {
  double axial_strain;           ///< of the specimen [-]
  double height;                 ///< of its center [m]
  double grains;                 ///< with their center inside [-]
  double porosity;               ///< overlaps counted twice as solid [-]
  double porosity_less_overlap;  ///< and once [-]
  double coordination_number;    ///< [-]
  double axial_stress;           ///< [Pa]
  double radial_stress;          ///< about the column's axis [Pa]
  double mean_force;             ///< of its contacts [N]
  double largest_force;          ///< the same [N]
};

/// One measuring sphere, its samples in order.
using SphereSeries = std::vector<SphereSample>;

/// The spheres from the lowest to the highest, of the samples `rows` that belong to the spheres
/// numbered `sphere`. Spheres with fewer samples than others, as of a block that was cut off, make
/// all as short.
std::vector<SphereSeries> sphere_series(const std::vector<double>& sphere,
                                        const std::vector<SphereSample>& rows);

/// One quantity of one sphere over time.
std::vector<double> over_time(const SphereSeries& sphere, double SphereSample::*quantity);

/// One quantity of all spheres, from the bottom, at sample `i`.
std::vector<double> along_column(const std::vector<SphereSeries>& spheres, std::size_t i,
                                 double SphereSample::*quantity);

/// Its mean over the spheres.
double mean_of_spheres(const std::vector<SphereSeries>& spheres, std::size_t i,
                       double SphereSample::*quantity);

/// The contact forces of the whole specimen at one time.
struct ContactSample {
  double axial_strain;             ///< of the specimen [-]
  double contacts;                 ///< their number [-]
  double mean_force;               ///< [N]
  double largest_force;            ///< [N]
  std::map<double, double> share;  ///< of the contacts that bear a level [-], by the level [N]
};

/// The level [N] whose share of the contacts stands below `heading`, which `fix output/contacts`
/// writes as "share_above_20N [-]"; nothing for other headings. Throws InputError if the level is
/// no number.
std::optional<double> level_of_share(const std::string& heading);

}  // namespace encased_column
