// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <ctime>

namespace encased_column {

/// Processor time of this thread [ns]: what others take does not count.
inline double thread_time()
{
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

}  // namespace encased_column
