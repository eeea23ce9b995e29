// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <cstdint>
#include <random>

namespace encased_column {

/// Uniform numbers in [0, 1), the same on every platform: the engine's sequence is fixed by the
/// C++ standard, that of std::uniform_real_distribution is not.
class UniformRandom {
 public:
  explicit UniformRandom(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace encased_column
