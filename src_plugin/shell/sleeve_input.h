// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/keyword_table.h"
#include "shell/sleeve.h"

namespace encased_column {

/// What a deck says of a sleeve.
const std::vector<Keyword>& sleeve_keywords();

// Each throws InputError.
SurfaceMesh read_sleeve_mesh(const Options& options);
ShellConstants read_shell_constants(const Options& options);
NodalMassRule read_nodal_mass_rule(const Options& options);
/// What the options do not name stays as in `now`.
SleeveControl read_sleeve_control(const Options& options, const SleeveControl& now);
/// Refuses what `fix_modify` cannot change.
void require_changeable(const Options& options);

}  // namespace encased_column
