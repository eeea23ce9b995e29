// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "surrogate/surrogate.h"

namespace encased_column {

/// A small neural network: the mean of five, each with one hidden layer of `network_neurons` and
/// weights of its own. Each leaves another fifth of the points out and keeps the weights with which
/// it foretells those best, so that it does not learn the noise of single runs.
std::unique_ptr<Surrogate> fit_network(const Data& data, unsigned seed);

constexpr unsigned network_neurons = 6;

}  // namespace encased_column
