// SPDX-License-Identifier: GPL-2.0-only
#pragma once

// The templates with which the host builds granular pair styles and walls, in the order in which
// they compile.
#include "host/host_types.h"

#include "fix_insert_stream.h"
#include "global_properties.h"
#include "settings.h"

#include "fix_wall_gran_base.h"
#include "pair_gran_base.h"
