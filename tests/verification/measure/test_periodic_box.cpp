// SPDX-License-Identifier: GPL-2.0-only
// Every style in a periodic box: it serves the images of the grains, in closed form, or refuses the
// box with a sentence.
#include "support/child_program.h"
#include "support/csv_table.h"
#include "verification/output/vtp_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <sstream>

using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const double pi = std::acos(-1.0);
constexpr double radius = 0.01, spacing = 0.0198;  // m
constexpr int cells = 4;                           // along each side of the box

std::string text(double number)
{
  std::ostringstream digits;
  digits.precision(17);
  digits << number;
  return digits.str();
}

std::string host(const std::string& boundary)
{
  return "units si\natom_style granular\natom_modify map array\nboundary " + boundary +
         "\nnewton off\ncommunicate single vel yes\n";
}

std::string box(const std::string& boundary, const std::string& low = "0")
{
  const std::string side = text(cells * spacing);
  return host(boundary) + "region box block " + low + " " + side + " " + low + " " + side + " 0 " +
         side + " units box\ncreate_box 2 box\n";
}

const std::string materials =
    "neighbor 0.0005 bin\nneigh_modify every 1 delay 0 check yes\n"
    "fix modulus all property/global contactModulus peratomtypepair 2 7e6 7e6 7e6 7e6\n"
    "fix kappa all property/global stiffnessRatio peratomtypepair 2 1 1 1 1\n"
    "fix friction all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
    "pair_style gran model linear tangential history\npair_coeff * *\ntimestep 1e-5\n";

/// A simple cubic lattice that fills the box, the first grain half a spacing from its corner.
std::string lattice()
{
  const std::string a = text(spacing);
  return "lattice custom 1 a1 " + a + " 0 0 a2 0 " + a + " 0 a3 0 0 " + a +
         " basis 0.5 0.5 0.5\ncreate_atoms 1 region box\n"
         "set group all diameter 0.02 density 2500\n";
}

/// Force of one of its contacts [N]: pi r E* / 2 times the overlap.
double contact_force()
{
  return 0.5 * pi * radius * 7e6 * (2.0 * radius - spacing);
}

const std::string held = "fix move all nve/sphere\n";
const std::string platens =
    "fix top all servo/platen position top z 0.07 side side type 2\n"
    "fix bottom all servo/platen position bottom z 0 side side type 2\n";
const std::string cylinder = "fix side all servo/cylinder radius 0.03 platens top bottom type 2\n";
const std::string sleeve =
    "fix side all mesh/surface/shell cylinder 0.03 0 0.07 edge 0.01 type 2 platens top bottom "
    "modulus 1e7 poisson 0.3 thickness 0.01 density 30\n";

const std::string packing =
    "print \"diameter_low [m],diameter_high [m],mass_percent [%]\" file gravel.csv\n"
    "print \"0.005,0.010,100\" append gravel.csv\n"
    "create_packing gradation gravel.csv cylinder 0.03 0 0.07 porosity 0.5 density 1738 type 1 "
    "seed 1\n" +
    std::string("fix move all nve/sphere\n") +
    "dump d all custom 1 grains.txt id radius x y z\ndump_modify d sort id\nrun 0\n";

/// What a style does in a periodic box.
struct Verdict {
  std::string boundary;
  std::string deck;     ///< behind the lattice, where it does not make its own grains
  std::string refusal;  ///< empty: it serves, and
  std::function<void(const Outcome&, const fs::path&)> check;
};

std::string not_periodic(const std::string& style, char direction, const std::string& found,
                         const std::string& write)
{
  return std::string("'") + style + "' needs a box that is not periodic along " + direction +
         ", found 'boundary " + found + "', write 'boundary " + write + "'";
}

void nothing_more(const Outcome&, const fs::path&) {}

const std::map<std::string, Verdict>& verdicts()
{
  static const std::map<std::string, Verdict> all{
      {"fix servo/platen",
       {"p p p", "fix a all servo/platen position top z 0.07 area 0.006 type 2\nrun 1\n",
        not_periodic("servo/platen", 'z', "p p p", "p p f"), nullptr}},
      {"fix servo/cylinder",
       {"f p f", cylinder + platens + "run 1\n",
        not_periodic("servo/cylinder", 'y', "f p f", "f f f"), nullptr}},
      {"fix mesh/surface/shell",
       {"p f f", sleeve + platens + "run 1\n",
        not_periodic("mesh/surface/shell", 'x', "p f f", "f f f"), nullptr}},
      // Both need walls, which refuse.
      {"fix specimen/history",
       {"p p f",
        cylinder + platens +
            "fix move all motion\nfix h all specimen/history platens top bottom side side motion "
            "move\nrun 1\n",
        not_periodic("servo/cylinder", 'x', "p p f", "f f f"), nullptr}},
      {"fix output/sleeve",
       {"p p f", sleeve + platens + "fix s all output/sleeve sleeve side every 1 folder s\nrun 1\n",
        not_periodic("mesh/surface/shell", 'x', "p p f", "f f f"), nullptr}},
      // Not along z alone: the upper of two platens on a periodic cell bears its sixteen columns.
      {"fix servo/platen on a cell",
       {"p p f",
        "fix a all servo/platen position top z 0.0792 area 0.00627264 type 2\n"
        "fix b all servo/platen position bottom z 0 area 0.00627264 type 2\n"
        "fix move all motion step 1.0\nrun 0\nvariable force equal f_a[2]\nprint \"force "
        "${force}\"\n",
        "",
        [](const Outcome& outcome, const fs::path&) {
          // The grains reach 0.1 mm beyond the platen; a wall's spring has pi r E*.
          EXPECT_NEAR(outcome.value("force"), 16.0 * pi * radius * 7e6 * 1e-4, 1e-2);
        }}},
      {"fix measure/sphere",
       {"p p p",
        held + "fix a all measure/sphere sphere 0 0 0 0.03 sphere " + text(2 * spacing) + " " +
            text(2 * spacing) + " " + text(2 * spacing) + " 0.03\nrun 0\n",
        "",
        [](const Outcome&, const fs::path& folder) {
          const auto porosity = CsvTable(folder / "spheres.csv").column("porosity [-]");
          EXPECT_NEAR(porosity.at(0), porosity.at(1), 1e-12);
        }}},
      // Three contacts a grain, each half of two of them, all of one force.
      {"fix output/contacts",
       {"p p p", held + "fix a all output/contacts every 1 folder c\nrun 0\n", "",
        [](const Outcome&, const fs::path& folder) {
          const CsvTable table(folder / "contacts.csv");
          EXPECT_EQ(table.column("contacts [-]").back(), 3.0 * cells * cells * cells);
          EXPECT_NEAR(table.column("mean_force [N]").back(), contact_force(),
                      1e-8 * contact_force());
        }}},
      // The forces of the six neighbours of a grain leave nothing over, at the border as inside.
      {"fix motion",
       {"p p p",
        "fix move all motion step 1.0\nrun 1\nvariable rest equal f_move[2]<1e-9\nprint \"rest "
        "${rest}\"\n",
        "",
        [](const Outcome& outcome, const fs::path&) { EXPECT_EQ(outcome.value("rest"), 1.0); }}},
      // 0.1 m in a box of 79.2 mm: once around, and all neighbours with it.
      {"fix output/grains",
       {"p p p",
        "velocity all set 10 0 0 units box\n" + held +
            "fix a all output/grains every 1000 folder g\nrun 1000\n",
        "",
        [](const Outcome&, const fs::path& folder) {
          const VtpFile file(folder / "g" / "grains_000001000.vtp");
          vtkDataArray* went = file.data()->GetPointData()->GetArray("displacement");
          ASSERT_EQ(went->GetNumberOfTuples(), cells * cells * cells);
          for (int n = 0; n < went->GetNumberOfTuples(); ++n) {
            EXPECT_NEAR(went->GetTuple3(n)[0], 0.1, 1e-7);
            EXPECT_LT(file.point(n)[0], cells * spacing + 1e-3) << "wrapped into the box";
          }
          for (const double contacts : file.of_points("coordination_number"))
            EXPECT_EQ(contacts, 6.0);
          for (const double strain : file.of_points("deviatoric_strain [-]"))
            EXPECT_NEAR(strain, 0.0, 1e-9);
        }}},
      {"fix grow/radius",
       {"p p p",
        held + "set group all diameter 0.01\nfix grow all grow/radius from 0.5 stages 2 relax 1\n"
               "fix a all measure/sphere sphere 0 0 0 0.15 every 2\nrun 2\n",
        "",
        [](const Outcome&, const fs::path& folder) {
          const double solid = 4.0 / 3.0 * pi * std::pow(radius / spacing, 3);
          EXPECT_NEAR(CsvTable(folder / "spheres.csv").column("porosity [-]").back(), 1.0 - solid,
                      2e-3);
        }}},
      {"fix output/restart",
       {"p p p", held + "fix a all output/restart every 1 file save\nrun 1\n", "",
        [](const Outcome&, const fs::path& folder) {
          const Outcome again = run_deck(host("p p p") + "read_restart save\n" + materials + held +
                                             "fix b all output/contacts every 1 folder c\nrun 0\n",
                                         1, folder);
          ASSERT_EQ(again.exit_code, 0) << again.output;
          EXPECT_EQ(CsvTable(folder / "contacts.csv").column("contacts [-]").back(),
                    3.0 * cells * cells * cells);
        }}},
      // These look at no position.
      {"fix output/collection",
       {"p p p",
        held + "fix g all output/grains every 1 folder g\nfix a all output/collection part g\n"
               "run 0\n",
        "", nothing_more}},
      {"solve",
       {"p p p", "fix move all motion\nsolve ratio average 1e-5 every 50 max 100\n", "",
        nothing_more}},
      {"create_wall_mesh",
       {"p p p", "create_wall_mesh file a.stl shape square half_width 0.1 z 0 edge 0.05\n", "",
        nothing_more}},
      {"record_variables",
       {"p p p", "variable n equal 1\nrecord_variables file variables.csv\n", "", nothing_more}},
      {"require", {"p p p", "variable n equal 1\nrequire variable n positive\n", "", nothing_more}},
      // Whole grains lie in the cylinder and the cylinder in the box: no image comes near, and the
      // grains are those of an open box.
      {"create_packing",
       {"p p p", packing, "",
        [](const Outcome&, const fs::path& folder) {
          const TemporaryFolder open;
          const Outcome again =
              run_deck(box("f f f", "-0.04") + materials + packing, 1, open.path());
          ASSERT_EQ(again.exit_code, 0) << again.output;
          const auto grains_of = [](const fs::path& place) {
            const std::string all = read_text(place / "grains.txt");
            return all.substr(all.find("ITEM: ATOMS"));
          };
          EXPECT_EQ(grains_of(folder), grains_of(open.path()));
        }}},
  };
  return all;
}

class PeriodicBox : public ::testing::TestWithParam<std::string> {};

std::vector<std::string> all_styles()
{
  std::vector<std::string> styles;
  for (const auto& [style, verdict] : verdicts()) styles.push_back(style);
  return styles;
}

}  // namespace

TEST_P(PeriodicBox, IsServedOrRefused)
{
  const Verdict& verdict = verdicts().at(GetParam());
  const TemporaryFolder folder;
  const bool packs = verdict.deck == packing;
  const std::string opening = packs ? box(verdict.boundary, "-0.04") + materials
                                    : box(verdict.boundary) + materials + lattice();
  const Outcome outcome = run_deck(opening + verdict.deck, 1, folder.path());
  if (verdict.refusal.empty()) {
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    verdict.check(outcome, folder.path());
  } else {
    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_TRUE(outcome.says(verdict.refusal)) << verdict.refusal << "\nnot in\n" << outcome.output;
  }
}

INSTANTIATE_TEST_SUITE_P(Styles, PeriodicBox, ::testing::ValuesIn(all_styles()),
                         [](const auto& style) {
                           std::string name = style.param;
                           for (char& c : name)
                             if (!std::isalnum(c)) c = '_';
                           return name;
                         });

TEST(PeriodicBox, HasAVerdictOfEveryStyle)
{
  for (const std::string& line : run_program({ENCASE_PROGRAM, "-styles"}, "/").lines()) {
    const std::string command = "command ";
    if (line.rfind("|", 0) == 0 || line.rfind("table ", 0) == 0 || line.empty()) continue;
    EXPECT_EQ(verdicts().count(line.rfind(command, 0) == 0 ? line.substr(command.size()) : line),
              1u)
        << line;
  }
}

// Spheres about points of the lattice that are alike, inside, on a face, an edge and a corner of
// the box, and one larger than the box, against sums over a lattice without end.
TEST(MeasureSphere, SeesTheImagesOfGrainsInAPeriodicBox)
{
  const double middle = 2 * spacing, small = 0.9 * spacing, large = 6.0 * spacing;
  const std::vector<std::vector<double>> centers{{middle, middle, middle},
                                                 {0.0, middle, middle},
                                                 {0.0, 0.0, middle},
                                                 {0.0, 0.0, 0.0},
                                                 {4 * spacing, 4 * spacing, 4 * spacing}};
  std::string spheres = "fix a all measure/sphere";
  for (const double r : {small, large})
    for (const auto& x : centers)
      spheres += " sphere " + text(x[0]) + " " + text(x[1]) + " " + text(x[2]) + " " + text(r);

  // Solid of a sphere about a corner of a cell, each lens as its two caps.
  const auto solid = [](double r) {
    const auto cap = [](double sphere, double h) { return pi * h * h * (3.0 * sphere - h) / 3.0; };
    double sum = 0.0;
    for (int i = -9; i < 9; ++i)
      for (int j = -9; j < 9; ++j)
        for (int k = -9; k < 9; ++k) {
          const double d = spacing * std::hypot(i + 0.5, j + 0.5, k + 0.5);
          if (d <= r - radius) sum += 4.0 / 3.0 * pi * std::pow(radius, 3);
          if (d <= r - radius || d >= r + radius) continue;
          const double plane = (d * d + r * r - radius * radius) / (2.0 * d);
          sum += cap(r, r - plane) + cap(radius, radius - (d - plane));
        }
    return sum;
  };
  for (const int ranks : {1, 2}) {
    const TemporaryFolder folder;
    const Outcome outcome = run_deck(
        box("p p p") + materials + lattice() + held + spheres + "\nrun 0\n", ranks, folder.path());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    const CsvTable table(folder.path() / "spheres.csv");
    ASSERT_EQ(table.rows(), 10u);
    for (std::size_t n = 0; n < table.rows(); ++n) {
      SCOPED_TRACE("sphere " + std::to_string(n) + " on " + std::to_string(ranks) + " ranks");
      const double r = n < centers.size() ? small : large;
      const double porosity = 1.0 - solid(r) / (4.0 / 3.0 * pi * r * r * r);
      const auto of = [&](const char* name) { return table.column(name)[n]; };
      EXPECT_NEAR(of("porosity [-]"), porosity, 1e-8);
      EXPECT_EQ(of("coordination_number [-]"), 6.0);
      EXPECT_NEAR(of("mean_contact_force [N]"), contact_force(), 1e-8 * contact_force());
      // Each grain inside has six contacts half a spacing from its center.
      const double volume = 4.0 / 3.0 * pi * std::pow(radius, 3);
      const double stress = (1.0 - porosity) / volume * contact_force() * spacing;
      for (const char* name : {"stress_xx [Pa]", "stress_yy [Pa]", "stress_zz [Pa]",
                               "axial_stress [Pa]", "radial_stress [Pa]", "hoop_stress [Pa]"})
        EXPECT_NEAR(of(name), stress, 1e-7 * stress) << name;
      for (const char* name : {"fabric_xx [-]", "fabric_yy [-]", "fabric_zz [-]"})
        EXPECT_NEAR(of(name), 1.0 / 3.0, 1e-8) << name;
    }
    // A large one comes near the porosity of the lattice, 0.476401 where grains just touch.
    const double lattice_porosity = 1.0 - 4.0 / 3.0 * pi * std::pow(radius / spacing, 3);
    EXPECT_NEAR(table.column("porosity [-]").back(), lattice_porosity, 5e-3);
  }
}
