// SPDX-License-Identifier: GPL-2.0-only
#include "reading/deck_inputs.h"

#include "runner/deck.h"

#include <cstdlib>
#include <filesystem>
#include <regex>

namespace encased_column {

namespace {

namespace fs = std::filesystem;

/// `value` with each ${name} in it replaced by that variable.
std::string resolved(std::string value, const CaseRun& run)
{
  std::smatch found;
  static const std::regex reference(R"(\$\{(\w+)\})");
  if (!std::regex_search(value, found, reference)) return value;
  const std::string name = found[1];
  for (const auto& [other, its_value] : run.inputs)
    if (other == name && its_value.find("${") == std::string::npos)
      return value.replace(static_cast<std::size_t>(found.position()),
                           static_cast<std::size_t>(found.length()), its_value);
  return value;
}

/// The deck that `run` was made with, empty if its folder has none. Of files that a variable
/// chooses it is those that the run's own choose: of two sets the one it used tells its sources.
Deck deck_of(const CaseRun& run)
{
  const fs::path input = run.folder / "input", file = input / (run.deck + ".lmp");
  if (!fs::is_regular_file(file)) return {};
  return read_deck(run.deck, file, input / "common", run.inputs);
}

}  // namespace

std::optional<double> usual_value(const CaseRun& run, const std::string& name)
{
  const Deck deck = deck_of(run);
  const DeckVariable* variable = deck.find(name);
  if (!variable) return std::nullopt;
  char* end = nullptr;
  const double number = std::strtod(variable->value.c_str(), &end);
  if (variable->value.empty() || *end) return std::nullopt;
  return number;
}

std::vector<DeckInput> deck_inputs(const CaseRun& run)
{
  const Deck deck = deck_of(run);
  std::vector<DeckInput> inputs;
  for (const auto& [name, value] : run.inputs) {
    const DeckVariable* known = deck.find(name);
    const bool has_unit = known && known->unit.size() > 2;
    inputs.push_back({name, resolved(value, run),
                      has_unit ? known->unit.substr(1, known->unit.size() - 2) : "-",
                      known && !known->meaning.empty() ? known->meaning : "-"});
  }
  return inputs;
}

}  // namespace encased_column
