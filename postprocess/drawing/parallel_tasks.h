// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include <functional>
#include <vector>

namespace encased_column {

/// Processes that draw at once on this machine: one a core, four at most, for each holds its
/// pictures in memory.
int drawing_processes();

/// Does `tasks` in `processes` processes that each take the next one left; VTK draws in one thread
/// of a process only. What they change in memory is lost: they write files. Throws InputError with
/// the sentence of the first task that threw one, when all have ended.
void do_in_processes(const std::vector<std::function<void()>>& tasks, int processes);

}  // namespace encased_column
