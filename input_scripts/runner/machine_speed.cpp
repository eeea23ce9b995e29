// SPDX-License-Identifier: GPL-2.0-only
#include "runner/machine_speed.h"

#include "core/input_error.h"
#include "runner/last_words.h"
#include "runner/passing_folder.h"
#include "runner/processes.h"
#include "runner/text_file.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <thread>
#include <vector>

namespace encased_column {

namespace fs = std::filesystem;

std::optional<double> seconds_per_grain_step(const std::string& log)
{
  std::optional<double> last;
  std::istringstream stream(log);
  for (std::string line; std::getline(stream, line);) {
    double seconds = 0.0, steps = 0.0, grains = 0.0;
    int procs = 0;
    if (std::sscanf(line.c_str(), "Loop time of %lf on %d procs for %lf steps with %lf atoms",
                    &seconds, &procs, &steps, &grains) == 4 &&
        seconds > 0.0 && steps * grains > 0.0)
      last = seconds * procs / (steps * grains);
  }
  return last;
}

double measure_machine(const Places& places, int at_once)
{
  const fs::path deck = places.inputs / "speed" / "packing.lmp";
  std::vector<PassingFolder> folders;
  std::vector<pid_t> programs;
  for (int n = 0; n < at_once; ++n) {
    folders.emplace_back("the speed of this machine is measured");
    programs.push_back(start_program({{places.host, "-in", deck, "-log", "log", "-screen", "none",
                                       "-var", "common", places.inputs / "common"},
                                      folders.back().path(),
                                      folders.back().path() / "screen",
                                      true,
                                      -1,
                                      folders.back().path()}));
  }
  for (const pid_t pid : programs)
    for (int code = 0; !has_ended(pid, code);)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
  double sum = 0.0;
  for (const PassingFolder& folder : folders) {
    const fs::path log = folder.path() / "log";
    const auto found =
        fs::exists(log) ? seconds_per_grain_step(read_text_file(log, "a log")) : std::nullopt;
    if (!found) {
      const std::string words = last_words_of(log, folder.path() / "screen");
      throw InputError("'" + deck.string() +
                       "' must run to its end to measure this machine, found that it does not" +
                       (words.empty() ? ", run '" + places.host.string() + "' to see why"
                                      : ", mend what it said last\n" + words));
    }
    sum += *found;
  }
  return sum / at_once;
}

}  // namespace encased_column
