// SPDX-License-Identifier: GPL-2.0-only
#include "reading/strip_table.h"

#include "reading/text_table.h"

#include <algorithm>

namespace encased_column {

namespace {

/// E t up to the strength: what the sleeve bears beyond it no strip test has shown.
StripTable straight_line(const CaseRun& run)
{
  const std::optional<double> modulus = run.number("modulus_sleeve"),
                              thickness = run.number("thickness"),
                              strength = run.number("strength");
  if (!modulus || !thickness || !strength || !(*modulus * *thickness > 0.0)) return {};
  return {{0.0, *strength / (*modulus * *thickness)}, {0.0, *strength}};
}

}  // namespace

StripTable strip_table(const CaseRun& run)
{
  if (!run.encased()) return {};
  const auto strip = std::find_if(run.inputs.begin(), run.inputs.end(),
                                  [](const auto& input) { return input.first == "strip"; });
  if (strip == run.inputs.end() || strip->second == "none") return straight_line(run);
  // Decks name it from the folder that they run in.
  const std::filesystem::path file = run.folder / strip->second;
  if (!std::filesystem::exists(file)) return {};
  const TextTable table(file);
  return {table.numbers("strain [-]"), table.numbers("hoop_tension [N/m]")};
}

}  // namespace encased_column
