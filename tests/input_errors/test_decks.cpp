// SPDX-License-Identifier: GPL-2.0-only
// The decks of the study refuse variables out of range before their first step, and the command
// `require`, by which they do, refuses rules that are none.
#include "input_errors/refusal.h"

using namespace encased_column::testing;

namespace {

struct BadVariable {
  std::string deck, name, value, sentence;
};

std::ostream& operator<<(std::ostream& out, const BadVariable& bad)
{
  return out << bad.deck << " " << bad.name << "=" << bad.value;
}

class Deck : public ::testing::TestWithParam<BadVariable> {};

const std::string plain = "triaxial_plain", encased = "triaxial_encased";

}  // namespace

TEST_P(Deck, RefusesAVariableOutOfRange)
{
  const BadVariable& bad = GetParam();
  const std::string inputs = ENCASE_SOURCE "/input_scripts/";
  const TemporaryFolder folder;
  const Outcome outcome =
      run_deck(read_text(inputs + bad.deck + "/" + bad.deck + ".lmp"), 1, folder.path(),
               {"-var", "common", inputs + "common", "-var", "parameters", "study", "-var",
                bad.name, bad.value});
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.says(bad.sentence)) << bad.sentence << "\nnot in\n" << outcome.output;
  EXPECT_FALSE(outcome.says("Setting up run")) << "refused after the packing began";
}

INSTANTIATE_TEST_SUITE_P(
    Variables, Deck,
    ::testing::Values(
        BadVariable{plain, "sigma3", "-50e3", "'sigma3' must be larger than zero, found -50000"},
        BadVariable{plain, "porosity", "0.65",
                    "'porosity' must be between 0.1 and 0.61, found 0.65"},
        BadVariable{plain, "sample_porosity", "41.7",
                    "'sample_porosity' must be between 0.2 and 0.6, found 41.7"},
        BadVariable{plain, "stress_packing", "-5e3",
                    "'stress_packing' must be zero or larger, found -5000"},
        BadVariable{plain, "gravity", "-9.8", "'gravity' must be zero or larger, found -9.8"},
        BadVariable{plain, "preload", "-1", "'preload' must be zero or larger, found -1"},
        BadVariable{plain, "relative_density", "80",
                    "'relative_density' must be between -1 and 1, found 80"},
        BadVariable{encased, "relative_density", "-0.5",
                    "'relative_density' must be between 0 and 1, found -0.5"},
        BadVariable{encased, "relative_density", "0.8", "friction 0.8, rolling friction 0, make"},
        BadVariable{plain, "modulus", "-7e6", "'modulus' must be larger than zero, found -7e+06"},
        BadVariable{plain, "kappa", "0", "'kappa' must be larger than zero, found 0"},
        BadVariable{plain, "mu", "-0.5", "'mu' must be zero or larger, found -0.5"},
        BadVariable{plain, "mu_cylinder", "-1", "'mu_cylinder' must be zero or larger, found -1"},
        BadVariable{plain, "alpha", "1", "'alpha' must be between 0 and 0.99, found 1"},
        BadVariable{plain, "rate", "-1", "'rate' must be zero or larger, found -1"},
        BadVariable{plain, "rate", "fast", "'rate' takes a finite number, found 'fast'"},
        BadVariable{plain, "moving", "3", "'moving' must be one of: 0, 1, 2; found '3'"},
        BadVariable{plain, "strain_end", "0",
                    "'strain_end' must be between 1e-06 and 0.9, found 0"},
        BadVariable{plain, "limit", "0", "'limit' must be larger than zero, found 0"},
        BadVariable{plain, "frames", "0", "'frames' must be 1 or larger, found 0"},
        BadVariable{plain, "seed", "1.5", "'seed' takes a whole number, found '1.5'"},
        BadVariable{plain, "radius", "0", "'radius' must be larger than zero, found 0"},
        BadVariable{plain, "density", "-1", "'density' must be larger than zero, found -1"},
        BadVariable{encased, "mu_sc", "-0.8", "'mu_sc' must be zero or larger, found -0.8"},
        BadVariable{encased, "thickness", "0", "'thickness' must be larger than zero, found 0"},
        BadVariable{encased, "moving", "both", "'moving' must be one of: 0, 1, 2; found 'both'"}));

TEST(Require, RefusesAVariableThatIsNotThere)
{
  expect_refused("two_grains", "require variable nu positive\n",
                 "'variable' must name a variable, found 'nu' and there is none, define it before");
}

TEST(Require, RefusesNoRuleAndTwo)
{
  expect_refused("two_grains", "variable nu index 0.3\nrequire variable nu\n",
                 "'require' takes one rule, found 0, write for example 'require variable nu "
                 "positive'");
  expect_refused("two_grains", "variable nu index 0.3\nrequire variable nu positive not_negative\n",
                 "'require' takes one rule, found 2");
}
