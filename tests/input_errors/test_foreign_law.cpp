// SPDX-License-Identifier: GPL-2.0-only
// Styles that take every contact for one of the linear law refuse another pair style, or another
// law of the host's walls beside it, before the first step.
#include "input_errors/refusal.h"

#include <map>
#include <set>
#include <sstream>

using namespace encased_column::testing;

namespace {

const std::string host_properties = R"(
fix e all property/global youngsModulus peratomtype 5e6 5e6
fix nu all property/global poissonsRatio peratomtype 0.3 0.3
fix rest all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5
fix kn all property/global kn peratomtypepair 2 1e5 1e5 1e5 1e5
fix kt all property/global kt peratomtypepair 2 1e5 1e5 1e5 1e5
fix gn all property/global gamman peratomtypepair 2 0 0 0 0
fix gt all property/global gammat peratomtypepair 2 0 0 0 0
)";

std::string host_law(const std::string& model)
{
  return host_properties + "pair_style gran model " + model + " tangential history\n" +
         "pair_coeff * *\n";
}

const std::string platens =
    "fix side all servo/cylinder radius 0.05 platens top bottom type 2\n"
    "fix top all servo/platen position top z 0.1 side side type 2\n"
    "fix bottom all servo/platen position bottom z 0 side side type 2\n";

/// Lines that make one fix of each style that reads the law, and what the sentence calls it.
const std::map<std::string, std::pair<std::string, std::string>> readers{
    {"motion", {"fix x all motion\n", "'fix x' of style motion"}},
    {"servo/cylinder", {platens, "'fix side' of style servo/cylinder"}},
    {"servo/platen",
     {"fix x all servo/platen position bottom z 0 area 0.01 type 2\n",
      "'fix x' of style servo/platen"}},
    {"mesh/surface/shell",
     {"fix side all mesh/surface/shell cylinder 0.05 0 0.1 edge 0.02 type 2 platens top bottom "
      "modulus 11.5e6 poisson 0.3 thickness 0.01 density 30\n" +
          platens.substr(platens.find('\n') + 1),
      "'fix side' of style mesh/surface/shell"}},
    {"measure/sphere",
     {"fix x all measure/sphere sphere 0 0 0.05 0.02 every 100\n",
      "'fix x' of style measure/sphere"}},
    {"specimen/history",
     {"fix move all motion every 50\n" + platens +
          "fix x all specimen/history platens top bottom side side motion move every 50\n",
      "'fix move' of style motion"}},
    {"output/grains",
     {"fix x all output/grains every 100 folder grains\n", "'fix x' of style output/grains"}},
    {"output/contacts",
     {"fix x all output/contacts every 100 folder contacts\n", "'fix x' of style output/contacts"}},
};

/// These look at no contact: radii grow, files are kept and listed, under any law.
const std::set<std::string> non_readers{"grow/radius", "output/collection", "output/restart",
                                        "output/sleeve"};

/// As expect_refused(), on one rank: where all ranks know the same no rank waits for another.
void expect_not_run(const std::string& lines, const std::string& sentence)
{
  const Outcome outcome = run_deck(opening_deck("grain_stack") + lines);
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.says(sentence)) << sentence << "\nnot in\n" << outcome.output;
  EXPECT_FALSE(outcome.says("Loop time"));
}

}  // namespace

class ForeignLaw : public ::testing::TestWithParam<std::string> {};

TEST_P(ForeignLaw, IsRefusedByEveryStyleThatReadsContacts)
{
  const auto& [lines, name] = readers.at(GetParam());
  expect_not_run(host_law("hertz") + lines + "run 1\n",
                 name +
                     " needs the linear contact law, found 'pair_style gran model hertz', write "
                     "'pair_style gran model linear tangential history'");
}

INSTANTIATE_TEST_SUITE_P(Styles, ForeignLaw, ::testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const auto& reader : readers) names.push_back(reader.first);
                           return names;
                         }()),
                         [](const auto& style) {
                           std::string name = style.param;
                           for (char& c : name)
                             if (c == '/') c = '_';
                           return name;
                         });

// A new style is in one of the two lists above, or this fails.
TEST(ForeignLaw, EveryStyleIsKnownToReadContactsOrNot)
{
  const TemporaryFolder folder;
  std::istringstream styles(run_program({ENCASE_PROGRAM, "-styles"}, folder.path()).output);
  for (std::string kind, name, line; std::getline(styles, line);) {
    std::istringstream words(line);
    words >> kind >> name;
    if (kind != "fix") continue;
    EXPECT_EQ(readers.count(name) + non_readers.count(name), 1u) << name;
  }
}

TEST(ForeignLaw, IsRefusedWhateverItIs)
{
  expect_not_run(host_law("hooke/stiffness") + "fix x all motion\nrun 1\n",
                 "found 'pair_style gran model hooke/stiffness'");
  expect_not_run("pair_style none\nfix x all motion\nrun 1\n", "found no pair style");
  expect_refused("grain_stack",
                 host_law("hertz") + "fix x all motion\nsolve ratio average 1 max 200\n",
                 "'fix x' of style motion needs the linear contact law");
}

TEST(ForeignLaw, IsRefusedInAWallOfTheHost)
{
  const std::string wall = "fix w all wall/gran model ";
  const std::string plane = " primitive type 2 zplane 0.0\n";
  expect_not_run(host_properties + "fix x all motion\n" + wall + "hertz tangential history" +
                     plane + "run 1\n",
                 "found 'model hertz' in fix w of style wall/gran, write 'model linear tangential "
                 "history' as for the pairs");
  expect_not_run(
      "fix r all property/global coefficientRollingFriction peratomtypepair 2 0 0 0 0\n"
      "fix x all motion\n" +
          wall + "linear tangential history rolling_friction epsd2" + plane + "run 1\n",
      "found 'model linear tangential history rolling_friction epsd2' in fix w");
}

TEST(ForeignLaw, RunsWhereNothingReadsContacts)
{
  const Outcome outcome = run_deck(opening_deck("grain_stack") + host_law("hertz") +
                                   "fix move all nve/sphere\nrun 1\nprint \"it ran\"\n");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.says("it ran")) << outcome.output;
}
