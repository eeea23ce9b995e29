// SPDX-License-Identifier: GPL-2.0-only
// Two writers of one file: the second is refused, whatever it is and whatever way it
// names the file.
#include "input_errors/refusal.h"

#include <fstream>

using namespace encased_column::testing;

namespace {

struct TwoWriters {
  std::string name;  ///< of the test
  std::string deck;
  std::string sentence;
};

const std::string walls =
    "fix side all servo/cylinder radius 0.05 platens top bottom type 2\n"
    "fix top all servo/platen position top z 0.08 side side type 2\n"
    "fix bottom all servo/platen position bottom z 0 side side type 2\n"
    "fix move all motion every 50\n";
const std::string history = " all specimen/history platens top bottom side side motion move ";
const std::string sphere = " all measure/sphere sphere 0 0 0.04 0.02 ";

std::string refused(const std::string& keyword, const std::string& file, const std::string& owner,
                    const std::string& second)
{
  return "'" + keyword + "' must be a file that nothing else writes, found '" + file + "', which " +
         owner + " writes, give " + second + " another name";
}

const std::vector<TwoWriters> pairs{
    {"TwoMeasuresOfSpheres", "fix a" + sphere + "\nfix b" + sphere + "\nrun 0\n",
     refused("file", "spheres.csv", "fix 'a' of style measure/sphere",
             "fix 'b' of style measure/sphere")},
    {"TwoHistories", walls + "fix a" + history + "\nfix b" + history + "\nrun 0\n",
     refused("file", "history.csv", "fix 'a' of style specimen/history",
             "fix 'b' of style specimen/history")},
    {"TwoSeriesOfGrains",
     "fix a all output/grains every 10 folder all\nfix b all output/grains every 20 folder all\n"
     "run 0\n",
     refused("name", "all/grains.pvd", "fix 'a' of style output/grains",
             "fix 'b' of style output/grains")},
    {"SeriesOfTwoStyles",
     "fix a all output/grains every 10 folder all name x\n"
     "fix b all output/contacts every 20 folder all name x\nrun 0\n",
     refused("name", "all/x.pvd", "fix 'a' of style output/grains",
             "fix 'b' of style output/contacts")},
    {"ACollectionAndOneOfItsParts",
     "fix a all output/grains every 10 folder .\n"
     "fix b all output/collection part a file grains.pvd\nrun 0\n",
     refused("file", "grains.pvd", "fix 'a' of style output/grains",
             "fix 'b' of style output/collection")},
    {"TwoRestartFiles",
     "fix a all output/restart every 10 file save\nfix b all output/restart every 20 file save\n"
     "run 0\n",
     refused("file", "save", "fix 'a' of style output/restart", "fix 'b' of style output/restart")},
    {"TablesOfTwoStylesUnderTwoNamesOfOneFile",
     "fix a" + sphere + "file all.csv\n" +
         "fix b all output/contacts every 10 folder c file ./../${PWD}/all.csv\nrun 0\n",
     "must be a file that nothing else writes, found './../"},
    {"TwoTablesOfOneFix",
     walls + "fix tube all mesh/surface/shell cylinder 0.055 0 0.2 edge 0.02 type 2 platens top "
             "bottom modulus 1e7 poisson 0.3 thickness 0.01 density 30\n"
             "fix a all output/sleeve sleeve tube every 10 folder s profile x.csv curves x.csv\n",
     refused("curves", "x.csv", "fix 'a' of style output/sleeve",
             "fix 'a' of style output/sleeve")},
    {"AWallMeshOverATable",
     "fix a" + sphere +
         "\ncreate_wall_mesh file spheres.csv shape square half_width 0.1 z 0 edge "
         "0.05\n",
     refused("file", "spheres.csv", "fix 'a' of style measure/sphere", "create_wall_mesh")},
    {"ATableOverAWallMesh",
     "create_wall_mesh file lid.stl shape square half_width 0.1 z 0 edge 0.05\n"
     "fix a" +
         sphere + "file lid.stl\n",
     refused("file", "lid.stl", "create_wall_mesh", "fix 'a' of style measure/sphere")},
    {"AFileOfFixPrint",
     "fix line all print 10 \"x\" file spheres.csv\nfix a" + sphere + "\nrun 0\n",
     refused("file", "spheres.csv", "the log or another command of the host",
             "fix 'a' of style measure/sphere")},
    {"AFileOfALaterFixPrint",
     "fix a" + sphere + "\nfix line all print 10 \"x\" file spheres.csv\nrun 0\n",
     refused("file", "spheres.csv", "the log or another command of the host",
             "fix 'a' of style measure/sphere")},
    {"ADump", "fix a" + sphere + "\ndump d all custom 10 spheres.csv id\nrun 0\n",
     refused("file", "spheres.csv", "dump 'd'", "fix 'a' of style measure/sphere")},
    {"TheLog", "fix a" + sphere + "file log.liggghts\nrun 0\n",
     refused("file", "log.liggghts", "the log or another command of the host",
             "fix 'a' of style measure/sphere")},
};

class Writers : public ::testing::TestWithParam<TwoWriters> {};

}  // namespace

TEST_P(Writers, OfOneFileAreRefused)
{
  // The first rank alone knows the owners and tells the others: one case on two ranks is enough.
  const bool is_first = GetParam().name == pairs.front().name;
  for (int ranks = 1; ranks <= (is_first ? 2 : 1); ++ranks) {
    const TemporaryFolder folder;
    std::string deck = GetParam().deck;
    const std::string here = "${PWD}/";
    if (const auto at = deck.find(here); at != std::string::npos)
      deck.replace(at, here.size(), folder.path().filename().string() + "/");
    const Outcome outcome = run_deck(opening_deck("grain_stack") + deck, ranks, folder.path());
    EXPECT_NE(outcome.exit_code, 0) << "on " << ranks << " ranks";
    EXPECT_TRUE(outcome.says(GetParam().sentence)) << GetParam().sentence << "\nnot in\n"
                                                   << outcome.output;
    EXPECT_FALSE(outcome.says("Loop time")) << "refused after the first step, not before";
  }
}

INSTANTIATE_TEST_SUITE_P(Writers, Writers, ::testing::ValuesIn(pairs),
                         [](const auto& pair) { return pair.param.name; });

// A file is free again with the fix that wrote it, and with the deck's `clear`; a command may
// write its own file again.
TEST(Writers, MayTakeAFileThatIsFreeAgain)
{
  const std::string twice =
      "fix a" + sphere + "every 10\nrun 0\nunfix a\nfix b" + sphere + "every 10\nrun 10\n" +
      "fix b" + sphere + "every 10\nrun 0\n" +
      "create_wall_mesh file lid.stl shape square half_width 0.1 z 0 edge 0.05\n"
      "create_wall_mesh file lid.stl shape square half_width 0.1 z 0 edge 0.02\n";
  const Outcome outcome = run_deck(
      opening_deck("grain_stack") + twice + "clear\n" + opening_deck("grain_stack") + "fix c" +
      sphere + "file lid.stl\n" + "fix d" + sphere + "\nrun 0\nprint \"done 1\"\n");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(outcome.value("done"), 1.0);
}
