// SPDX-License-Identifier: GPL-2.0-only
#include "support/small_triaxial.h"

#include <fstream>

namespace encased_column::testing {

namespace fs = std::filesystem;

namespace {

const fs::path inputs = fs::path(ENCASE_SOURCE) / "input_scripts";

}  // namespace

std::string plain_triaxial_deck()
{
  return read_text(inputs / "triaxial_plain/triaxial_plain.lmp");
}

std::string encased_triaxial_deck()
{
  std::string deck = read_text(inputs / "triaxial_encased/triaxial_encased.lmp");
  const std::string include = "include ${common}/encased_test.lmp";
  return deck.replace(deck.find(include), include.size(),
                      read_text(inputs / "common/encased_test.lmp"));
}

Outcome run_small_triaxial(const fs::path& folder, int ranks)
{
  return run_small_triaxial(folder, ranks, plain_triaxial_deck());
}

void prepare_small_resolution(const fs::path& folder)
{
  fs::copy(inputs / "common", folder / "common", fs::copy_options::recursive);
  std::ofstream(folder / "common/resolution_small.lmp") << "variable finest equal 10e-3\n"
                                                           "variable skin equal 1e-3\n"
                                                           "variable looser equal 0\n"
                                                           "variable facet_here equal 5e-3\n"
                                                           "variable rate_here equal 6e-7\n";
}

std::vector<std::string> prepare_small_triaxial(const fs::path& folder)
{
  prepare_small_resolution(folder);
  std::vector<std::string> arguments;
  const std::vector<std::pair<std::string, std::string>> variables{
      {"common", "common"},   {"resolution", "small"}, {"parameters", "study"},
      {"radius", "0.03"},     {"height", "0.06"},      {"porosity", "0.40"},
      {"strain_end", "0.02"}, {"limit", "1e-4"},       {"sigma3", "50e3"}};
  for (const auto& [name, value] : variables)
    arguments.insert(arguments.end(), {"-var", name, value});
  return arguments;
}

Outcome run_small_triaxial(const fs::path& folder, int ranks, const std::string& deck)
{
  return run_deck(deck, ranks, folder, prepare_small_triaxial(folder));
}

}  // namespace encased_column::testing
