// SPDX-License-Identifier: GPL-2.0-only
// Every variable of both decks is set to a second value, and the run itself must show that it used
// it: the file in which it says its variables, and the commands that its log has.
#include "runner/case_record.h"
#include "runner/case_variables.h"
#include "support/run_command.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

/// Second values, each unlike its default; small and short.
const Settings of_both{
    {"resolution", "small"},
    {"parameters", "laboratory"},
    {"sigma3", "51e3"},
    {"porosity", "0.41"},
    {"sample_porosity", "0.403"},
    {"modulus", "7.1e6"},
    {"kappa", "3.4"},
    {"mu", "0.79"},
    {"mu_r", "0.011"},
    {"mu_packing", "0.3"},
    {"mu_platen", "0.71"},
    {"alpha", "0.69"},
    {"alpha_packing", "0.68"},
    {"alpha_rest", "0.66"},
    {"looser_quick", "0.08"},
    {"looser_standard", "0.04"},
    {"gradation", ENCASE_SOURCE "/input_scripts/common/gradation_cinder_gravel.csv"},
    {"safety", "0.79"},
    {"rate", "1.31e-6"},
    {"moving", "2"},
    {"gravity", "9.7"},
    {"free_speed", "1.3e-6"},
    {"strain_end", "0.003"},
    {"limit", "3e-3"},
    {"floating", "1"},
    {"seed", "7"},
    {"frames", "3"},
    {"chains", "4.7"},
    {"restart_every", "713"},
    {"radius", "0.031"},
    {"height", "0.061"},
    {"density", "1741"},
    {"stress_packing", "4900"},
    {"relative_density", "0.31"},
    {"preload", "60e3"}};
const Settings of_plain{{"mu_cylinder", "0.02"}};
const Settings of_encased{{"mu_sc", "0.77"},
                          {"modulus_sc", "6.9e7"},
                          {"kappa_sc", "0.9"},
                          {"modulus_sleeve", "1.2e7"},
                          {"poisson_sleeve", "0.29"},
                          {"thickness", "9.7e-3"},
                          {"bending_thickness", "8e-3"},
                          {"facet", "6e-3"},
                          {"top_end", "clamped"},
                          {"bottom_end", "radial"},
                          {"overhang", "0.001"},
                          {"strip", ENCASE_SOURCE "/input_scripts/common/strip_geotextile.csv"},
                          {"tension_only", "yes"},
                          {"strength", "9.1e3"},
                          {"strength_axial", "9.05e3"},
                          {"after_strength", "tear"},
                          {"fracture_energy", "120"},
                          {"seam", "0.9"},
                          {"strain_limit", "0.6"},
                          {"seam_angle", "11"},
                          {"when_torn", "go_on"},
                          {"spheres", "2"},
                          {"axial_servo", "1"}};
/// These take their value from one above unless they are given, so they have runs of their own.
const Settings of_side{{"modulus_side", "7.3e6"}, {"kappa_side", "2.9"}};
/// A cloth that tears does not harden.
const Settings of_yield{{"after_strength", "yield"}, {"hardening", "9.1e3"}};
const Settings short_run{{"limit", "3e-3"}, {"strain_end", "0.003"}};

/// The commands of a log by the variable they name: `${name}` or v_name.
class Log {
 public:
  explicit Log(const fs::path& file)
  {
    std::istringstream stream(read_text(file));
    for (std::string line; std::getline(stream, line);) lines_.push_back(line);
  }

  /// True if a command of the host takes `name`, at once or by way of another variable.
  bool uses(const std::string& name, std::set<std::string> seen = {}) const
  {
    if (!seen.insert(name).second) return false;
    for (const std::string& line : lines_) {
      if (line.find("${" + name + "}") == std::string::npos && !has_word(line, "v_" + name))
        continue;
      std::istringstream words(line);
      std::string command, other;
      words >> command >> other;
      if (command == "print" && other == "\"variable") {  // into a file that is included
        command = "variable";
        words >> other;
      }
      if (command == "require" || command == "print") continue;
      if (command != "variable" || uses(other, seen)) return true;
    }
    return false;
  }

 private:
  static bool has_word(const std::string& line, const std::string& word)
  {
    const std::size_t at = line.find(word);
    return at != std::string::npos &&
           (at + word.size() == line.size() ||
            !(std::isalnum(line[at + word.size()]) || line[at + word.size()] == '_'));
  }
  std::vector<std::string> lines_;
};

class EveryVariable : public ::testing::Test {
 protected:
  void SetUp() override
  {
    prepare_small_cases(folder_.path());
    std::ofstream(folder_.path() / "common/resolution_small.lmp", std::ios::app)
        << "variable looser equal 0*(v_looser_quick+v_looser_standard)\n";
    // What the deck packing_limits/limits.lmp finds for the grains of the second values.
    std::ofstream(folder_.path() / "common/packing_limits.csv", std::ios::app)
        << "gradation_cinder_gravel.csv,uniform_number,0.01,0.031,0.061,0.79,0.011,7.1e6,5e3,1,"
           "0.5021,0.4424\n";
  }

  fs::path case_folder(const std::string& id) const { return folder_.path() / out_ / id; }

  void run(const std::string& id, const Settings& settings, const std::string& out = "out")
  {
    out_ = out;
    std::vector<std::string> options{"--case", id, "--ranks", "1"};
    for (const auto& [name, value] : settings)
      options.insert(options.end(), {"--set", name + "=" + value});
    const Outcome outcome = RunningCommand(folder_.path(), out, options).end();
    ASSERT_TRUE(outcome.says("Case " + id + " finished in")) << outcome.output;
  }
  /// What the run says it used is what was set, and its log shows a command that takes it.
  void expect_used(const std::string& id, const Settings& settings) const
  {
    const Settings used = read_used_variables(case_folder(id) / "variables.csv");
    const Settings recorded = read_case_record(case_folder(id) / "case.json").used;
    const Log log(case_folder(id) / "log.liggghts");
    for (const Setting& setting : settings) {
      for (const Settings& told : {used, recorded}) {
        const auto found = std::find_if(told.begin(), told.end(),
                                        [&](const Setting& s) { return s.first == setting.first; });
        ASSERT_NE(found, told.end()) << setting.first;
        EXPECT_TRUE(same_value(found->second, setting.second)) << setting.first;
      }
      EXPECT_TRUE(log.uses(setting.first)) << "no command takes " << setting.first;
    }
  }
  /// The names of all variables the deck of `id` offers.
  std::set<std::string> offered(const std::string& id) const
  {
    std::set<std::string> names;
    for (const Setting& s : read_case_record(case_folder(id) / "case.json").asked)
      names.insert(s.first);
    return names;
  }
  void expect_all_set(const std::string& id, Settings settings) const
  {
    settings.insert(settings.end(), of_side.begin(), of_side.end());
    std::set<std::string> names;
    for (const Setting& setting : settings) names.insert(setting.first);
    EXPECT_EQ(offered(id), names) << "give each variable of the deck a second value here";
  }

  TemporaryFolder folder_;
  std::string out_;
};

Settings joined_settings(Settings a, const Settings& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

TEST_F(EveryVariable, OfThePlainDeckReachesTheRun)
{
  const Settings all = joined_settings(of_both, of_plain);
  run("plain", all);
  expect_used("plain", all);
  expect_all_set("plain", all);
  run("plain", joined_settings(short_run, of_side), "side");
  expect_used("plain", of_side);
}

TEST_F(EveryVariable, OfTheEncasedDeckReachesTheRun)
{
  const Settings all = joined_settings(of_both, of_encased);
  run("encased", all);
  expect_used("encased", all);
  expect_all_set("encased", joined_settings(all, of_yield));
  const Settings beside = joined_settings(of_side, of_yield);
  run("encased", joined_settings(short_run, beside), "side");
  expect_used("encased", beside);
}

// The runner compares what it has read of the set with what the host has used; --set comes before
// the set. Few grains pack looser than the set asks for.
TEST_F(EveryVariable, OfTheSetOfTheLaboratoryReachesTheRun)
{
  const Settings set{{"parameters", "laboratory"}, {"porosity", "0.51"}, {"mu_platen", "0.7"}};
  for (const std::string id : {"plain", "encased"}) {
    run(id, joined_settings(short_run, set));
    expect_used(id, set);
  }
}

// This test must see a variable that a deck offers and no command takes.
TEST_F(EveryVariable, ThatNobodyUsesIsFound)
{
  const fs::path deck = folder_.path() / "triaxial_plain.lmp";
  const std::string text = read_text(deck);
  std::ofstream(deck) << "variable nobody index 3  # [-] idle\nvariable twice equal 2*${nobody}\n"
                      << text;
  run("plain", joined_settings(short_run, {{"nobody", "4"}}));
  const Log log(case_folder("plain") / "log.liggghts");
  EXPECT_FALSE(log.uses("nobody"));
  EXPECT_TRUE(log.uses("sigma3"));
}
