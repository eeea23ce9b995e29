// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "shell/number_row.h"
#include "shell/shell_model.h"

namespace encased_column {

// What a sleeve keeps of its nodes and facets in a restart file, as numbers in a row.

/// Position, rotation, velocities, mass and inertia of each node.
void save_nodes(const ShellModel& model, std::vector<double>& numbers);
void restore_nodes(ShellModel& model, NumberRow& numbers);

/// Plastic strain, damage and slip of facets [first, last), zeros for all others: sums over ranks
/// that share the facets are those of all.
std::vector<double> memory_numbers(const ShellModel& model, int first, int last);
void take_memory(ShellModel& model, const std::vector<double>& numbers);

/// Of a cloth that remembers the energy [J] that yielding and tearing took, and the memory of each
/// facet; of others nothing.
void save_memory(const ShellModel& model, double dissipated, std::vector<double>& numbers);
/// Throws InputError where the file has no memory, or one that the sleeve cannot have.
void restore_memory(ShellModel& model, NumberRow& numbers);

}  // namespace encased_column
