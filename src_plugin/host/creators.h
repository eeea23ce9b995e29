#pragma once

#include "host/host_types.h"

namespace encased_column {

/// How the host makes the object of a style.
using FixCreator = LAMMPS_NS::Fix* (*)(LAMMPS_NS::LAMMPS*, int, char**);
using CommandCreator = void (*)(LAMMPS_NS::LAMMPS*, int, char**);

}  // namespace encased_column
