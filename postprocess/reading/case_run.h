// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "reading/text_table.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace encased_column {

/// One run of a triaxial deck: what was asked for (case.json) and what came out (history.csv).
struct CaseRun {
  std::filesystem::path folder;
  std::string id, deck;
  std::string title;       ///< with the confining stress and the resolution it was made with
  std::string reproduces;  ///< of the study; empty if the case does not say
  std::vector<std::pair<std::string, std::string>> inputs;  ///< all variables, in the deck's order
  std::string resolution;                                   ///< empty if the deck has none
  std::string parameters;  ///< the set its values are from; empty if the deck has none
  std::map<std::string, double> variables;  ///< the numbers among the deck's variables
  std::string gradation;    ///< what its file is called, "S2"; empty if the deck has none
  bool has_sleeve = false;  ///< it has written a sleeve's files
  double confining_stress;  ///< sigma3 asked for [Pa]
  TextTable history;        ///< samples of the shear stage
  std::optional<double> generation_porosity;  ///< at full size, as gradation.csv reports it [-]

  /// The deck's variable `name`; nothing if it has none that is a number.
  std::optional<double> number(const std::string& name) const;
  bool encased() const { return has_sleeve; }
  /// Encased and more slender than a triaxial specimen, which is two diameters high.
  bool column() const;
  /// The set of the published values this run belongs to, as targets.csv calls it.
  std::string set() const
  {
    return column() ? "column" : encased() ? "encased_triaxial" : "plain_triaxial";
  }
};

/// What a file of size classes is called in the study's way: "gradation_column_S2.csv" is S2,
/// "my_gradation.csv" my_gradation.
std::string gradation_name(const std::filesystem::path& file);

/// The runs found, and a sentence for each folder that was left out and why.
struct CaseRuns {
  std::vector<CaseRun> runs;  ///< plain, encased, columns; then by parameters, confining stress
  std::vector<std::string> left_out;
};

/// Reads `folders`, each a case folder (it holds case.json) or a series of them. Throws InputError
/// if a folder given holds no case, if a file cannot be read, or if no triaxial run is left. In a
/// series, cases that have not reached shear and decks that are not triaxial are left out.
CaseRuns read_case_runs(const std::vector<std::filesystem::path>& folders);

}  // namespace encased_column
