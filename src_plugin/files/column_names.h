// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "files/column.h"

// The names of all columns, once for the fixes that write them and the reports that read them.
namespace encased_column {

/// Of `fix specimen/history`.
namespace history_column {
inline constexpr ColumnName step{"step", "-"};
inline constexpr ColumnName axial_strain{"axial_strain", "-"};
inline constexpr ColumnName stress_top{"stress_top", "Pa"};
inline constexpr ColumnName stress_bottom{"stress_bottom", "Pa"};
inline constexpr ColumnName confining_stress{"confining_stress", "Pa"};
inline constexpr ColumnName deviatoric_stress_top{"deviatoric_stress_top", "Pa"};
inline constexpr ColumnName deviatoric_stress_bottom{"deviatoric_stress_bottom", "Pa"};
inline constexpr ColumnName mean_stress{"mean_stress", "Pa"};
inline constexpr ColumnName volumetric_strain{"volumetric_strain", "-"};
inline constexpr ColumnName height{"height", "m"};
inline constexpr ColumnName radius{"radius", "m"};
inline constexpr ColumnName porosity{"porosity", "-"};
inline constexpr ColumnName porosity_less_overlap{"porosity_less_overlap", "-"};
inline constexpr ColumnName coordination_number{"coordination_number", "-"};
inline constexpr ColumnName mechanical_coordination_number{"mechanical_coordination_number", "-"};
inline constexpr ColumnName radial_strain_25{"radial_strain_25", "-"};
inline constexpr ColumnName radial_strain_50{"radial_strain_50", "-"};
inline constexpr ColumnName radial_strain_75{"radial_strain_75", "-"};
inline constexpr ColumnName unbalanced_average{"unbalanced_average", "-"};
inline constexpr ColumnName unbalanced_maximum{"unbalanced_maximum", "-"};
inline constexpr ColumnName inertial_number{"inertial_number", "-"};
inline constexpr ColumnName work_platens{"work_platens", "J"};
inline constexpr ColumnName work_side{"work_side", "J"};
inline constexpr ColumnName work_gravity{"work_gravity", "J"};
inline constexpr ColumnName energy_elastic{"energy_elastic", "J"};
inline constexpr ColumnName energy_kinetic{"energy_kinetic", "J"};
inline constexpr ColumnName loss_friction{"loss_friction", "J"};
inline constexpr ColumnName loss_rolling{"loss_rolling", "J"};
inline constexpr ColumnName loss_dashpots{"loss_dashpots", "J"};
inline constexpr ColumnName loss_damping{"loss_damping", "J"};
inline constexpr ColumnName energy_error{"energy_error", "-"};
inline constexpr ColumnName core_axial_stress{"core_axial_stress", "Pa"};
inline constexpr ColumnName core_radial_stress{"core_radial_stress", "Pa"};
inline constexpr ColumnName loss_yielding{"loss_yielding", "J"};
inline constexpr ColumnName unbalanced_bearing{"unbalanced_bearing", "-"};
}  // namespace history_column

/// Of `fix measure/sphere`.
namespace sphere_column {
inline constexpr ColumnName step{"step", "-"};
inline constexpr ColumnName sphere{"sphere", "-"};
inline constexpr ColumnName x{"x", "m"};
inline constexpr ColumnName y{"y", "m"};
inline constexpr ColumnName z{"z", "m"};
inline constexpr ColumnName radius{"radius", "m"};
inline constexpr ColumnName grains{"grains", "-"};
inline constexpr ColumnName porosity{"porosity", "-"};
inline constexpr ColumnName porosity_less_overlap{"porosity_less_overlap", "-"};
inline constexpr ColumnName coordination_number{"coordination_number", "-"};
inline constexpr ColumnName mechanical_coordination_number{"mechanical_coordination_number", "-"};
inline constexpr ColumnName axial_stress{"axial_stress", "Pa"};
inline constexpr ColumnName radial_stress{"radial_stress", "Pa"};
inline constexpr ColumnName hoop_stress{"hoop_stress", "Pa"};
inline constexpr ColumnName stress_xx{"stress_xx", "Pa"};
inline constexpr ColumnName stress_yy{"stress_yy", "Pa"};
inline constexpr ColumnName stress_zz{"stress_zz", "Pa"};
inline constexpr ColumnName stress_xy{"stress_xy", "Pa"};
inline constexpr ColumnName stress_xz{"stress_xz", "Pa"};
inline constexpr ColumnName stress_yz{"stress_yz", "Pa"};
inline constexpr ColumnName fabric_xx{"fabric_xx", "-"};
inline constexpr ColumnName fabric_yy{"fabric_yy", "-"};
inline constexpr ColumnName fabric_zz{"fabric_zz", "-"};
inline constexpr ColumnName fabric_xy{"fabric_xy", "-"};
inline constexpr ColumnName fabric_xz{"fabric_xz", "-"};
inline constexpr ColumnName fabric_yz{"fabric_yz", "-"};
inline constexpr ColumnName sliding_fraction{"sliding_fraction", "-"};
inline constexpr ColumnName mean_contact_force{"mean_contact_force", "N"};
inline constexpr ColumnName largest_contact_force{"largest_contact_force", "N"};
}  // namespace sphere_column

/// Of `fix output/contacts`; for each level [N] two more, named by it.
namespace contact_column {
inline constexpr ColumnName step{"step", "-"};
inline constexpr ColumnName contacts{"contacts", "-"};
inline constexpr ColumnName grain_contacts{"grain_contacts", "-"};
inline constexpr ColumnName wall_contacts{"wall_contacts", "-"};
inline constexpr ColumnName sleeve_contacts{"sleeve_contacts", "-"};
inline constexpr ColumnName sliding_fraction{"sliding_fraction", "-"};
inline constexpr ColumnName mean_force{"mean_force", "N"};
inline constexpr ColumnName largest_force{"largest_force", "N"};
inline const std::string contacts_above = "contacts_above_", share_above = "share_above_";
inline const std::string level_end = "N [-]";
}  // namespace contact_column

/// Of the profile of `fix output/sleeve`.
namespace profile_column {
inline constexpr ColumnName step{"step", "-"};
inline constexpr ColumnName axial_strain{"axial_strain", "-"};
inline constexpr ColumnName z{"z", "m"};
inline constexpr ColumnName radius{"radius", "m"};
inline constexpr ColumnName radial_displacement{"radial_displacement", "m"};
inline constexpr ColumnName hoop_strain{"hoop_strain", "-"};
inline constexpr ColumnName hoop_tension{"hoop_tension", "N/m"};
}  // namespace profile_column

/// Of the curves of `fix output/sleeve`.
namespace sleeve_column {
inline constexpr ColumnName step{"step", "-"};
inline constexpr ColumnName axial_strain{"axial_strain", "-"};
inline constexpr ColumnName pressure{"pressure", "Pa"};
inline constexpr ColumnName hoop_tension_mean{"hoop_tension_mean", "N/m"};
inline constexpr ColumnName hoop_tension_max{"hoop_tension_max", "N/m"};
inline constexpr ColumnName hoop_strain_mean{"hoop_strain_mean", "-"};
inline constexpr ColumnName hoop_strain_max{"hoop_strain_max", "-"};
inline constexpr ColumnName axial_force_top_end{"axial_force_top_end", "N"};
inline constexpr ColumnName axial_force_bottom_end{"axial_force_bottom_end", "N"};
inline constexpr ColumnName friction_force{"friction_force", "N"};
inline constexpr ColumnName enclosed_volume{"enclosed_volume", "m^3"};
inline constexpr ColumnName energy{"energy", "J"};
inline constexpr ColumnName plastic_hoop_strain_max{"plastic_hoop_strain_max", "-"};
inline constexpr ColumnName damage_max{"damage_max", "-"};
inline constexpr ColumnName dissipated{"dissipated", "J"};
}  // namespace sleeve_column

}  // namespace encased_column
