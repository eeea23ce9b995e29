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
