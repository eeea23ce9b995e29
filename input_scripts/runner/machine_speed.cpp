#include "runner/machine_speed.h"

#include "core/input_error.h"
#include "runner/processes.h"
#include "runner/text_file.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <thread>
#include <vector>

namespace encased_column {

namespace fs = std::filesystem;

namespace {

/// A folder that goes with this object.
class PassingFolder {
 public:
  PassingFolder()
  {
    std::string name = (fs::temp_directory_path() / "encase_speed_XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw InputError(
          "the speed of this machine is measured in a folder of its own, found that '" + name +
          "' cannot be made, write another TMPDIR");
    path_ = name;
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  ~PassingFolder()
  {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

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
  const PassingFolder folder;
  std::vector<pid_t> programs;
  std::vector<fs::path> logs;
  for (int n = 0; n < at_once; ++n) {
    logs.push_back(folder.path() / ("log." + std::to_string(n)));
    programs.push_back(
        start_program({{places.host, "-in", places.inputs / "speed" / "packing.lmp", "-log",
                        logs.back(), "-screen", "none", "-var", "common", places.inputs / "common"},
                       folder.path(),
                       folder.path() / "screen",
                       true,
                       -1}));
  }
  for (const pid_t pid : programs)
    for (int code = 0; !has_ended(pid, code);)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
  double sum = 0.0;
  for (const fs::path& log : logs) {
    const auto found =
        fs::exists(log) ? seconds_per_grain_step(read_text_file(log, "a log")) : std::nullopt;
    if (!found)
      throw InputError(
          "'speed/packing.lmp' must run to its end to measure this machine, found that "
          "it does not, run '" +
          places.host.string() + " -in " + (places.inputs / "speed" / "packing.lmp").string() +
          "' to see why");
    sum += *found;
  }
  return sum / at_once;
}

}  // namespace encased_column
