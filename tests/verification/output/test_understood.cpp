// SPDX-License-Identifier: GPL-2.0-only
// The log says what each fix understood: every default that the keyword tables promise is in the
// line of a fix whose deck gives only what it must.
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <map>
#include <regex>

using namespace encased_column::testing;

namespace {

const std::string every_fix =
    "fix side all mesh/surface/shell cylinder 0.05 0 0.08 edge 0.02 type 2 platens top bottom "
    "modulus 1.15e7 poisson 0.3 thickness 0.01 density 30\n"
    "fix tube all servo/cylinder radius 0.055 platens top bottom type 2\n"
    "fix top all servo/platen position top z 0.08 side side type 2\n"
    "fix bottom all servo/platen position bottom z 0 area 0.008 servo 5e3 ramp 10 type 2\n"
    "fix move all motion\n"
    "fix grow all grow/radius from 0.5\n"
    "fix history all specimen/history platens top bottom side side motion move\n"
    "fix balls all measure/sphere sphere 0 0 0.04 0.03 sphere 0 0 0.05 0.02 folder spheres\n"
    "fix grains all output/grains every 10 folder grains\n"
    "fix contacts all output/contacts every 10 folder contacts\n"
    "fix sleeve all output/sleeve sleeve side every 10 folder sleeve\n"
    "fix together all output/collection part grains part sleeve\n"
    "fix save all output/restart every 10 file save\n"
    "fix_modify top velocity 5e-7\n"
    "fix_modify bottom gain 0.5\n"
    "fix_modify history reference\n"
    "fix_modify move damping 0.5\n"
    "fix_modify side top_end radial pressure 2e4 ramp 100\n";

/// The lines of the log that say what a fix understood, by what stands before "uses".
std::map<std::string, std::string> lines_of_the_log(const std::filesystem::path& folder)
{
  std::map<std::string, std::string> found;
  std::istringstream log(read_text(folder / "log.liggghts"));
  static const std::regex form(R"((fix\w* \w+ \([\w/]+\)) uses: (.*))");
  std::smatch parts;
  for (std::string line; std::getline(log, line);)
    if (std::regex_match(line, parts, form)) found[parts[1]] = parts[2];
  return found;
}

/// The default that a row of a keyword table promises, or nothing: "`name` | 1 | - | ... (default
/// 200)" or "yes (default) or no".
std::string promised(const std::string& row)
{
  static const std::regex name(R"(\| `(\w+)` \| (\d+) \|.*)");
  static const std::regex said(R"(.*\(default ([\w.]+)\).*)"),
      marked(R"(.*[ `](\w+)`? \(default\).*)");
  std::smatch keyword, value;
  if (!std::regex_match(row, keyword, name)) return "";
  if (!std::regex_match(row, value, said) && !std::regex_match(row, value, marked)) return "";
  return keyword.str(2) == "0" ? keyword.str(1) : keyword.str(1) + " " + value.str(1);
}

}  // namespace

TEST(Understood, IsEveryDefaultThatTheKeywordTablesPromise)
{
  const TemporaryFolder folder;
  const Outcome outcome = run_deck(opening_deck("grain_stack") + every_fix, 2, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const auto lines = lines_of_the_log(folder.path());
  std::string style, line;
  int promises = 0;
  for (const std::string& row : run_program({ENCASE_PROGRAM, "-styles"}, "/").lines()) {
    if (row.rfind("fix ", 0) == 0) {
      style = row.substr(4);
      line.clear();
      for (const auto& [fix, words] : lines)
        if (fix.rfind("fix ", 0) == 0 && fix.find("(" + style + ")") != std::string::npos)
          line += ", " + words + ",";
      EXPECT_FALSE(line.empty()) << "no line of fix " << style;
    } else if (row.rfind("command ", 0) == 0) {
      style.clear();
    }
    const std::string wanted = style.empty() ? "" : promised(row);
    if (wanted.empty()) continue;
    EXPECT_NE(line.find(", " + wanted + ","), std::string::npos)
        << "'" << wanted << "' is not in '" << line << "' of fix " << style;
    ++promises;
  }
  EXPECT_GT(promises, 25);
}

TEST(Understood, IsWhatTheDeckGaveInItsOwnWordsOnceForAllRanks)
{
  const TemporaryFolder folder;
  const Outcome outcome = run_deck(opening_deck("grain_stack") + every_fix, 1, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const auto lines = lines_of_the_log(folder.path());
  EXPECT_EQ(lines.at("fix history (specimen/history)"),
            "platens top bottom, side side, motion move, every 200, file history.csv");
  EXPECT_EQ(lines.at("fix balls (measure/sphere)"),
            "sphere 0 0 0.04 0.03, sphere 0 0 0.05 0.02, axis 0 0, every 1000, file spheres.csv, "
            "folder spheres, frames 1000, name spheres");
  EXPECT_EQ(lines.at("fix bottom (servo/platen)"),
            "type 2, servo 5e3, ramp 10, gain 0.8, patience 50000, position bottom, z 0, area "
            "0.008");
  EXPECT_EQ(lines.at("fix_modify top (servo/platen)"),
            "type 2, velocity 5e-7, gain 0.8, patience 50000");
  EXPECT_EQ(lines.at("fix_modify bottom (servo/platen)"),
            "type 2, servo 5000, gain 0.5, patience 50000");
  EXPECT_EQ(lines.at("fix_modify history (specimen/history)"), "reference");
  EXPECT_EQ(lines.at("fix_modify move (motion)"), "damping 0.5");
  EXPECT_EQ(lines.at("fix side (mesh/surface/shell)"),
            "cylinder 0.05 0 0.08, edge 0.02, type 2, platens top bottom, modulus 1.15e7, poisson "
            "0.3, thickness 0.01, bending_thickness 0.01, density 30, tension_only no, top_end "
            "held, bottom_end held, rigid no, pressure 0, pressed between, damping 0.7, "
            "mass_scaling yes, safety 0.8, every 50, strain_limit 0.5, strip none, after_strength "
            "warn, when_torn stop");
  EXPECT_EQ(lines.at("fix_modify side (mesh/surface/shell)"),
            "top_end radial, bottom_end held, rigid no, pressure 2e4, ramp 100, pressed between, "
            "damping 0.7, strain_limit 0.5, when_torn stop");
  EXPECT_EQ(lines.at("fix contacts (output/contacts)"),
            "every 10, folder contacts, name contacts, threshold 0, rows 1000, file contacts.csv, "
            "level 5 20 40 60");
}
