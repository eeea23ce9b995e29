// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "host/host_types.h"

namespace encased_column {

/// Makes every style of the table known to `lmp`, now and again after the deck's `clear`.
void register_styles(LAMMPS_NS::LAMMPS* lmp);

}  // namespace encased_column
