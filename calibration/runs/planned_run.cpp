// SPDX-License-Identifier: GPL-2.0-only
#include "runs/run_program.h"

#include <cstdio>
#include <cstdlib>

namespace encased_column {

std::string PlannedRun::id() const
{
  char start[40];
  std::snprintf(start, sizeof start, "p%04d_r%d_", key.point, key.repeat);
  return start + key.name;
}

double PlannedRun::number(const std::string& name, double otherwise) const
{
  for (auto one = variables.rbegin(); one != variables.rend(); ++one)
    if (one->first == name) return std::atof(one->second.c_str());
  return otherwise;
}

}  // namespace encased_column
