// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/places.h"

#include <string>

namespace encased_column {

/// "0.2.0, commit b0c3e01": of the sources this program was built from.
std::string project_version();

/// The same with host, compiler and MPI, one a line, as `liggghts-encase -version` tells them; what
/// is to be done where it does not start.
std::string versions(const Places& places);

}  // namespace encased_column
