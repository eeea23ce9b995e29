// SPDX-License-Identifier: GPL-2.0-only
// What goes wrong is called by its name, and the sentence says what to write.
#include "support/child_program.h"

#include <gtest/gtest.h>

#include <cstdlib>

using namespace encased_column::testing;

namespace {

struct Misuse {
  const char* name;
  std::string opening;
  std::string lines;
  std::string sentence;
};

void PrintTo(const Misuse& misuse, std::ostream* out)
{
  *out << misuse.name;
}

const std::string motion = "unfix move\nfix move all motion\n";
const std::string grain = "create_atoms 1 single 0 0 0.1 units box\n";

const Misuse misuses[] = {
    {"TwoGrainsAtOnePlace", "two_grains",
     motion + grain + "set group all diameter 0.02 density 2500\nrun 1\n",
     "grains must be at different places, found grain 1 and grain 3 at the same, create them once"},
    {"StepSetBackInARun", "two_grains", motion + "run 1\nreset_timestep 0\n",
     "'reset_timestep' must not be used where contacts remember the step"},
    {"StepSetBackBehindARestart", "two_grains",
     motion + "run 1\nwrite_restart r\nclear\natom_style granular\natom_modify map array\n"
              "newton off\ncommunicate single vel yes\nread_restart r\n"
              "reset_timestep 0\nfix move all motion\n",
     "'reset_timestep' must not be used where contacts remember the step"},
    {"RestartBehindABox", "two_grains", "write_restart r\nread_restart r\n",
     "'read_restart' makes the box itself, found one before it"},
    {"NoGrainIsLeft", "two_grains", motion + "run 1\ndelete_atoms group all\nrun 1\n",
     "there must be a grain before the first step, found none"},
    {"TooManySteps", "two_grains", motion + "run 3000000000\n",
     "'run' takes a whole number of steps from 0 to 2147483647"},
    {"CylinderClosed", "grain_stack",
     "fix side all servo/cylinder radius 0.05 platens top bottom type 2 velocity 110\n"
     "fix top all servo/platen position top z 0.1 side side type 2\n"
     "fix bottom all servo/platen position bottom z 0 side side type 2\n"
     "fix move all motion step 1e-4\nrun 100\n",
     "'radius' must stay larger than zero, found -0.005"},
    {"GrainThatLeft", "two_grains",
     motion + "thermo_modify lost error\ngroup one id 1\n"
              "velocity one set 0 0 200 units box\nrun 100\n",
     "of 2 grains 1 are left at step 100: the others left the box"},
};

class Misleading : public ::testing::TestWithParam<Misuse> {};

}  // namespace

TEST_P(Misleading, TextsAreNot)
{
  const Outcome outcome = run_deck(opening_deck(GetParam().opening) + GetParam().lines);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(outcome.says("ERROR: ") && outcome.says(GetParam().sentence)) << outcome.output;
}

INSTANTIATE_TEST_SUITE_P(Misuses, Misleading, ::testing::ValuesIn(misuses),
                         [](const auto& misuse) { return misuse.param.name; });

// The host ends some of its errors with a joke, one in five by the second of the clock, that it has
// freed before. Here every number it draws is zero, with which all have one.
TEST(Misleading, JokeOfTheHostIsLeftOut)
{
  setenv("LD_PRELOAD", ENCASE_DRAWS_ZERO, 1);
  for (const std::string line :
       {"fix move all motion dampnig 0.7", "fix euler all ave/euler nevery",
        "compute near all coord/atom", "compute joke all ke/multisphere 1 2", "fix nobody"}) {
    const Outcome outcome = run_deck(opening_deck("two_grains") + "unfix move\n" + line + '\n');
    EXPECT_EQ(outcome.exit_code, 1) << line;
    const std::size_t sentence = outcome.output.find("ERROR: ");
    ASSERT_NE(sentence, std::string::npos) << line << '\n' << outcome.output;
    EXPECT_EQ(outcome.output.find('\n', sentence), outcome.output.size() - 1) << line << '\n'
                                                                              << outcome.output;
  }
  unsetenv("LD_PRELOAD");
}
