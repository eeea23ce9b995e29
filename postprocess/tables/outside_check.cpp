// SPDX-License-Identifier: GPL-2.0-only
#include "tables/outside_check.h"

#include "analysis/run_checks.h"
#include "files/column_names.h"
#include "reading/frame_files.h"

#include <algorithm>
#include <array>
#include <vector>

namespace encased_column {

namespace {

namespace fs = std::filesystem;

Check outside(const std::string& of_what, long found)
{
  return {"grains with their center outside " + of_what + ", last file of grains",
          static_cast<double>(found), 0.0, true};
}

Check not_made(const std::string& reason)
{
  return {"grains outside the walls (not looked for: " + reason + ")", 0.0, 0.0, true, false};
}

/// The sleeve at `time`, if the run wrote one.
std::optional<fs::path> sleeve_at(const fs::path& folder, double time)
{
  const fs::path collection = folder / "sleeve" / "sleeve.pvd";
  if (!fs::exists(collection)) return std::nullopt;
  const auto frames = frame_files(collection);
  const auto found = frames.find(time);
  if (found == frames.end() || !fs::exists(found->second)) return std::nullopt;
  return found->second;
}

}  // namespace

Check outside_check(const CaseRun& run, const std::optional<GrainFile>& grains)
{
  if (!grains) return not_made("the run left no file of grains");
  const std::optional<double> built = run.number("height"), moving = run.number("moving");
  if (!built || !moving)
    return not_made("case.json has no height or no moving, which place the platens");
  if (!run.history.has(history_column::step)) return not_made("history.csv has no steps");

  // The decks run with a time step of one: times of files are steps.
  const std::vector<double> steps = run.history.numbers(history_column::step);
  const auto row = std::find(steps.begin(), steps.end(), grains->time);
  if (row == steps.end()) return not_made("history.csv has no row of the step of its last file");
  const auto at = static_cast<std::size_t>(row - steps.begin());
  const std::vector<double> heights = run.history.numbers(history_column::height);
  WallPlaces walls{platen_heights(*built, heights.front(), heights[at], static_cast<int>(*moving)),
                   {}};
  if (!run.encased()) walls.radius = run.history.numbers(history_column::radius)[at];

  std::vector<std::array<double, 3>> inside;
  for (const std::array<double, 3>& center : grains->centers)
    if (!is_outside(center, walls)) inside.push_back(center);
  const long beyond = grains->grains - static_cast<long>(inside.size());
  if (!run.encased()) return outside("platens and cylinder", beyond);
  const auto sleeve = sleeve_at(run.folder, grains->time);
  if (!sleeve) return outside("the platens", beyond);
  return outside("platens and sleeve", beyond + count_beyond_sleeve(inside, *sleeve));
}

}  // namespace encased_column
