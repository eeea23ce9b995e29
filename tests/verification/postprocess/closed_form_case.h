// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <filesystem>
#include <string>

namespace encased_column::testing {

inline constexpr double sigma3 = 50e3;                                     // Pa
inline constexpr double kp_of_core = 3.92, core_radial = 100e3;            // -, Pa
inline constexpr double q_top = 900e3, q_bottom = 300e3, q_plain = 146e3;  // Pa

/// The folder of a test of constant volume, `kind` plain or encased and so called, with these
/// stresses from 0.1 to 22 % strain and no energies; without `core` its history lacks those of the
/// middle third. All stresses are `factor` times these, those beyond
/// the confining one `strength` times more. A row every 0.1 % and 100 steps; `height` [m]
/// high and 0.05 m in radius at first.
void write_case(const std::filesystem::path& folder, const std::string& kind, bool core = true,
                double factor = 1.0, double strength = 1.0, double height = 0.2);

/// Rewrites its case.json with these variables: `"sigma3": 50000, "resolution": "quick"`. It stands
/// beside the study unless `reproduces` is empty, as with a deck of one's own.
void describe_case(const std::filesystem::path& folder, const std::string& kind,
                   const std::string& variables, const std::string& reproduces = "Table 2");

}  // namespace encased_column::testing
