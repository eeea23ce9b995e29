// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "runner/places.h"

namespace encased_column {

/// `encase doctor`: looks at the machine, says what is there and what to do; 1 where something
/// needs mending.
int doctor_command(const Places& places);

}  // namespace encased_column
