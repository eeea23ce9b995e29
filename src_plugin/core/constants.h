// SPDX-License-Identifier: GPL-2.0-only
#pragma once

namespace encased_column {

constexpr double pi = 3.14159265358979323846;

}  // namespace encased_column
