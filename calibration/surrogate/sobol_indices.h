// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "surrogate/polynomial.h"

namespace encased_column {

/// A share of the variance of a value [-] and how far off it may be.
struct SobolIndex {
  double value, error;  ///< error: half the width of its 95 % interval
};

/// What parameters have to do with the variance of a value over the cube.
struct SobolIndices {
  std::vector<SobolIndex> first;  ///< of each parameter alone
  std::vector<SobolIndex> total;  ///< with all its interactions
  double unexplained;             ///< share that the polynomial does not foretell, leave-one-out
};

/// Indices from the coefficients of `polynomial`, fitted to `data` before. Their errors: 1.96 times
/// the scatter over `resamples` fits of the same terms to points drawn again from the same ones,
/// and on top the share that the polynomial does not explain, which may be anybody's. Sources: B.
/// Sudret, "Global sensitivity analysis using polynomial chaos expansions", Reliab. Eng. Syst. Saf.
/// 93 (2008), 964-979; S. Marelli, B. Sudret, "An active-learning algorithm that combines sparse
/// polynomial chaos expansions and bootstrap", Struct. Saf. 75 (2018), 67-74.
SobolIndices sobol_indices(const Polynomial& polynomial, const Data& data, int resamples,
                           unsigned seed);

}  // namespace encased_column
