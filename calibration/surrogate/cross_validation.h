// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "surrogate/surrogate.h"

#include <vector>

namespace encased_column {

/// Rows that are learnt from and rows that are foretold.
struct Fold {
  std::vector<Eigen::Index> learnt, left_out;
};

/// Parts rows into `count` folds, or as many as there are groups: rows of one group stay together,
/// as a packing repeated at the same point would tell what is to be foretold.
std::vector<Fold> folds_of(const std::vector<int>& groups, int count, unsigned seed);

/// How well a surrogate foretells what it has not seen.
struct Validation {
  SurrogateKind kind;
  Eigen::VectorXd foretold;  ///< each row by a surrogate fitted without its fold
  double error;              ///< root of the mean square of foretold minus found
  double score;              ///< cross-validated R2: 1 - error^2 / variance of the values
};

/// Fits and foretells in `folds` parts.
Validation cross_validate(SurrogateKind kind, const Data& data, int folds, unsigned seed);

/// The validation with the least error. `all` must not be empty.
const Validation& better_of(const std::vector<Validation>& all);

/// Root mean square of foretold minus found over the third of the rows, ten at least, whose
/// foretold values are the nearest to `value`: the error where it matters.
double error_near(const Validation& validation, const Data& data, double value);

}  // namespace encased_column
