// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <string>
#include <vector>

namespace encased_column {

/// Debian's VTK draws through an X display only. Where there is none, starts this program again
/// with `arguments` (without its name) under xvfb-run, in its place: does not return. Throws
/// InputError if xvfb-run is not installed. Returns at once where there is a display.
void provide_display(const std::vector<std::string>& arguments);

/// Why no picture can be drawn here, in one sentence; empty if one can. Takes some seconds where
/// xvfb-run makes the display.
std::string display_problem();

}  // namespace encased_column
