// SPDX-License-Identifier: GPL-2.0-only
#pragma once

// The host's headers are not self-contained: this one includes what every adapter needs, in an
// order that compiles.
#include "lammps.h"
#include "pointers.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

namespace encased_column {

/// How the host makes the object of a style.
using FixCreator = LAMMPS_NS::Fix* (*)(LAMMPS_NS::LAMMPS*, int, char**);
using CommandCreator = void (*)(LAMMPS_NS::LAMMPS*, int, char**);

}  // namespace encased_column
