// SPDX-License-Identifier: GPL-2.0-only
#include "input_errors/refusal.h"

using namespace encased_column::testing;

namespace {

const std::string header =
    "print \"diameter_low [m],diameter_high [m],mass_percent [%]\" file gravel.csv\n";

/// A `create_packing` of a gradation with the classes `lines`, with `changed` in place of porosity.
std::string packing(const std::string& lines, const std::string& changed = "porosity 0.4")
{
  return header + lines + "create_packing gradation gravel.csv cylinder 0.05 0 0.2 density 1738 " +
         "type 1 seed 1 " + changed + "\nrun 1\n";
}

const std::string one_class = "print \"0.005,0.010,100\" append gravel.csv\n";

}  // namespace

TEST(Packing, RefusesAGradationThatDoesNotSumTo100)
{
  expect_refused("empty_cylinder",
                 packing("print \"0.002,0.005,20\" append gravel.csv\n"
                         "print \"0.005,0.010,75\" append gravel.csv\n"),
                 "'gradation' gravel.csv: the mass percents of a gradation must sum to 100, found "
                 "95, correct the percents");
}

TEST(Packing, RefusesAPorosityOutOfReach)
{
  expect_refused("empty_cylinder", packing(one_class, "porosity 0.04"),
                 "'porosity' must be between 0.1 and 0.7, found 0.04");
}

TEST(Packing, RefusesAPorosityInPercent)
{
  expect_refused("empty_cylinder", packing(one_class, "porosity 40"),
                 "'porosity' must be between 0.1 and 0.7, found 40");
}

TEST(Packing, RefusesADistributionItDoesNotKnow)
{
  expect_refused("empty_cylinder", packing(one_class, "porosity 0.4 distribution normal"),
                 "'distribution' must be one of: log_uniform, uniform, uniform_number; found "
                 "'normal', write for example 'distribution log_uniform'");
}

TEST(Packing, RefusesATiltedBox)
{
  const Outcome outcome = run_deck(R"(
units      si
atom_style granular
region     box prism -0.06 0.06 -0.06 0.06 -0.01 0.21 0.01 0 0 units box
create_box 1 box
)" + packing(one_class));
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(
      outcome.says("create_packing: the box must not be tilted, found xy = 0.01, xz = 0 and "
                   "yz = 0, write a region of style block for 'create_box'"))
      << outcome.output;
}

TEST(Packing, RefusesToStandBeforeTheBox)
{
  const Outcome outcome = run_deck("units si\natom_style granular\n" + packing(one_class));
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_TRUE(
      outcome.says("create_packing: there must be a box, found none yet, write 'create_box' "
                   "before it"))
      << outcome.output;
}

TEST(Packing, RefusesWhatFindsNoRoom)
{
  expect_refused("empty_cylinder", packing(one_class, "porosity 0.2 start_factor 1"),
                 "write a smaller one, for example 'start_factor 0.5'");
}

TEST(Packing, RefusesAFileThatIsNotThere)
{
  expect_refused("empty_cylinder",
                 "create_packing gradation no.csv cylinder 0.05 0 0.2 porosity 0.4 density 1738 "
                 "type 1 seed 1\nrun 1\n",
                 "'gradation' must name a file that can be read, found 'no.csv', check the path "
                 "from where the deck runs");
}

TEST(Packing, RefusesAReportThatCannotBeWritten)
{
  expect_refused("empty_cylinder", packing(one_class, "porosity 0.4 report no_folder/report.csv"),
                 "'report' must be a file that can be written, found 'no_folder/report.csv', "
                 "create its folder or give another name");
}

TEST(Growth, RefusesAStartBeyondTheFullRadius)
{
  expect_refused("one_grain", "fix grow all grow/radius from 1.5\nrun 1\n",
                 "'from' must be between 0.01 and 1, found 1.5, write for example 'from 0.5'");
}

TEST(Growth, RefusesNoStages)
{
  expect_refused("one_grain", "fix grow all grow/radius from 0.5 stages 0\nrun 1\n",
                 "'stages' must be 1 or larger, found 0, write for example 'stages 1'");
}

TEST(Growth, RefusesASpecimenThatIsNotThereAndAMotionThatWeighsTooSeldom)
{
  const std::string walls =
      "fix side all servo/cylinder radius 0.0247 platens top bottom type 2\n"
      "fix top all servo/platen position top z 0.08 side side type 2\n"
      "fix bottom all servo/platen position bottom z 0 side side type 2\n"
      "fix move all motion\n"
      "fix grow all grow/radius from 0.9 stress 5e3 ";
  expect_refused("grain_stack", walls + "platens top lid side side\nrun 1\n",
                 "'platens' must name a fix servo/platen, found 'lid'");
  expect_refused("grain_stack", walls + "relax 60 platens top bottom side side\nrun 1\n",
                 "'relax' must be a multiple of the 'every' of fix move with 'stress', found 60 "
                 "and 50, write for example 'relax 50'");
}

TEST(Packing, RefusesARelativeDensityInPercent)
{
  expect_refused("empty_cylinder",
                 packing(one_class, "relative_density 80 limits limits.csv 0.7 0.5"),
                 "'relative_density' must be between 0 and 1, found 80");
}

TEST(Packing, RefusesBothWaysToSayHowDense)
{
  expect_refused("empty_cylinder",
                 packing(one_class, "porosity 0.4 relative_density 0.8 limits limits.csv 0.7 0.5"),
                 "a packing takes one of 'porosity' and 'relative_density', found both");
}

TEST(Packing, RefusesLimitsOfAnotherPacking)
{
  expect_refused("empty_cylinder",
                 packing(one_class, "relative_density 0.8 limits " ENCASE_SOURCE
                                    "/input_scripts/common/packing_limits.csv 0.7 0.5"),
                 "for gravel.csv log_uniform, finest 0 m, radius 0.05 m, height 0.2 m, friction "
                 "0.7, rolling friction 0.5, make one with the deck packing_limits/limits.lmp");
}
