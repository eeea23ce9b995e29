// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>

namespace encased_column {

/// The file that `read_restart` opens for `pattern`: with a `*` that of the latest step in its
/// folder. Throws InputError when there is none.
std::string restart_file_of(const std::string& pattern);

/// Walks through a restart file from its first byte to its last grain, as the host's `read_restart`
/// will, which takes any number it finds as a size of memory or a count. With a `%` in its name the
/// file is one of several. Throws InputError for a file that is cut off or is no restart file.
void check_restart_file(const std::string& file);

}  // namespace encased_column
