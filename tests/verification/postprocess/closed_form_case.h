#pragma once

#include <filesystem>
#include <string>

namespace encased_column::testing {

inline constexpr double sigma3 = 50e3;                                     // Pa
inline constexpr double kp_of_core = 3.92, core_radial = 100e3;            // -, Pa
inline constexpr double q_top = 900e3, q_bottom = 300e3, q_plain = 146e3;  // Pa

/// The folder of a test of constant volume, `kind` plain or encased and so called, with these
/// stresses from 0.1 to 22 % strain and no energies; without `core` its history lacks those of the
/// middle third.
void write_case(const std::filesystem::path& folder, const std::string& kind, bool core = true);

}  // namespace encased_column::testing
