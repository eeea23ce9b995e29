// SPDX-License-Identifier: GPL-2.0-only
#include "input_errors/refusal.h"

#include <array>
#include <fstream>
#include <vector>

using namespace encased_column::testing;

namespace {

const std::string grain =
    "create_atoms 1 single 0 0 0.1 units box\nset group all diameter 0.01 density 2500\n";
const std::string mesh = " cylinder 0.05 0 0.2 edge 0.02";
const std::string platens = " type 2 platens top bottom";
const std::string material = " modulus 11.5e6 poisson 0.3 thickness 0.01 density 30";
const std::string walls =
    "\nfix top all servo/platen position top z 0.2 side side type 2\n"
    "fix bottom all servo/platen position bottom z 0 side side type 2\n"
    "fix move all motion step 1.0\n";

/// Expects that a sleeve with these words does not start.
void expect_no_sleeve(const std::string& words, const std::string& sentence,
                      const std::string& after = "")
{
  expect_refused("empty_cylinder",
                 grain + "fix side all mesh/surface/shell" + words + walls + after + "run 1\n",
                 sentence);
}

/// A tube of four sides and three rows, 2 cm wide and 3 cm high, as an ASCII STL file, but for what
/// `change` does to its 24 triangles.
template <typename Change>
std::filesystem::path tube_file(const TemporaryFolder& folder, const Change& change)
{
  struct Corner {
    double x, y, z;
  };
  std::vector<std::array<Corner, 3>> triangles;
  const double x[] = {0.01, -0.01, -0.01, 0.01}, y[] = {0.01, 0.01, -0.01, -0.01};
  for (const double z : {0.0, 0.01, 0.02})
    for (int i = 0; i < 4; ++i) {
      const int j = (i + 1) % 4;
      const double up = z + 0.01;
      const Corner a{x[i], y[i], z}, b{x[j], y[j], z}, c{x[j], y[j], up}, d{x[i], y[i], up};
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  change(triangles);
  const auto path = folder.path() / "tube.stl";
  std::ofstream file(path);
  file << "solid tube\n";
  for (const auto& triangle : triangles) {
    file << "facet normal 0 0 0\nouter loop\n";
    for (const Corner& c : triangle) file << "vertex " << c.x << " " << c.y << " " << c.z << "\n";
    file << "endloop\nendfacet\n";
  }
  file << "endsolid tube\n";
  return path;
}

template <typename Change>
void expect_no_mesh(const Change& change, const std::string& sentence)
{
  const TemporaryFolder folder;
  const std::string path = tube_file(folder, change);
  expect_no_sleeve(" file " + path + platens + material, sentence);
}

}  // namespace

TEST(Sleeve, RefusesAMeshWithAHole)
{
  expect_no_mesh([](auto& triangles) { triangles.erase(triangles.begin() + 11); },
                 "the mesh of a sleeve needs exactly two borders, its two ends, found");
}

TEST(Sleeve, RefusesAnInvertedFacet)
{
  expect_no_mesh([](auto& triangles) { std::swap(triangles[11][0], triangles[11][1]); },
                 "neighbouring facets of the mesh must be oriented alike, found facets");
}

TEST(Sleeve, RefusesADoubleFacet)
{
  expect_no_mesh([](auto& triangles) { triangles.push_back(triangles[11]); },
                 "every facet of the mesh must stand once, found facet 24");
}

TEST(Sleeve, RefusesMoreFacetsThanAMachineHolds)
{
  expect_no_sleeve(" cylinder 0.05 0 0.2 edge 1e-6" + platens + material,
                   "edge of the sleeve must leave 1000000 facets at most, found 1e-06");
}

TEST(Sleeve, RefusesAMeshThatLies)
{
  expect_no_mesh(
      [](auto& triangles) {
        for (auto& triangle : triangles)
          for (auto& corner : triangle) std::swap(corner.x, corner.z);
      },
      "the axis of a sleeve must stand along z, one end above the other, found the lower end up to "
      "0.01 m and the upper one down to -0.01 m: turn the mesh");
}

TEST(Sleeve, RefusesAThicknessThatIsNone)
{
  const std::string rest = mesh + platens + " modulus 11.5e6 poisson 0.3 density 30";
  expect_no_sleeve(
      rest + " thickness 0",
      "'thickness' must be larger than zero, found 0, write for example 'thickness 1'");
  expect_no_sleeve(
      rest + " thickness -0.01",
      "'thickness' must be larger than zero, found -0.01, write for example 'thickness 0.01'");
}

TEST(Sleeve, RefusesAPoissonsRatioOutOfItsRange)
{
  const std::string rest = mesh + platens + " modulus 11.5e6 thickness 0.01 density 30";
  for (const std::string ratio : {"-1", "0.5", "0.7"})
    expect_no_sleeve(
        rest + " poisson " + ratio,
        "poisson of the shell must lie in (-1, 0.5), found " + ratio + ": write for instance 0.3");
}

TEST(Sleeve, RefusesAnEndOfUnknownKind)
{
  expect_no_sleeve(mesh + platens + material + " top_end glued",
                   "'top_end' must be one of: held, clamped, radial, platen, free; found 'glued', "
                   "write for example 'top_end held'");
}

TEST(Sleeve, RefusesAPlatenThatIsNotThere)
{
  expect_no_sleeve(mesh + " type 2 platens top base" + material,
                   "'platens' must name a fix servo/platen, found 'base' and no fix has that ID, "
                   "define it before");
}

TEST(Sleeve, RefusesThePlatensTheWrongWayRound)
{
  expect_no_sleeve(mesh + " type 2 platens bottom top" + material,
                   "'platens' takes the upper platen first, found 'bottom top', write the ID of "
                   "the top and then of the bottom one");
}

TEST(Sleeve, RefusesAPressureThatRampsOverNoSteps)
{
  expect_no_sleeve(mesh + platens + material + " pressure 50e3 ramp 0",
                   "'ramp' must be 1 or larger, found 0, write for example 'ramp 1'");
  expect_no_sleeve(mesh + platens + material + " ramp 100",
                   "'ramp' goes with 'pressure', found it alone, write 'pressure 50e3 ramp 1000'");
}

TEST(Sleeve, RefusesAnUnknownKeyword)
{
  expect_no_sleeve(mesh + platens + material + " thicknes 0.01",
                   "unknown keyword 'thicknes', expected one of: cylinder, edge, file, type,");
}

TEST(Sleeve, RefusesAMissingValueOrKeyword)
{
  expect_no_sleeve(mesh + platens + material + " pressure",
                   "keyword 'pressure' takes 1 value, found 0, add what is missing");
  expect_no_sleeve(mesh + material + " type 2", "keyword 'platens' is missing");
  expect_no_sleeve(" cylinder 0.05 0 0.2" + platens + material, "keyword 'edge' is missing");
}

TEST(Sleeve, TakesOneOfCylinderAndFile)
{
  const std::string rest = platens + material;
  expect_no_sleeve(rest, "a sleeve takes one of 'cylinder' and 'file', found neither");
  expect_no_sleeve(mesh + " file tube.stl" + rest,
                   "a sleeve takes one of 'cylinder' and 'file', found both");
  expect_no_sleeve(
      " file tube.stl edge 0.01" + rest,
      "'edge' goes with 'cylinder', found it with 'file', whose facets are given, leave it out");
}

TEST(Sleeve, RefusesAFileThatCannotBeRead)
{
  expect_no_sleeve(" file nowhere.stl" + platens + material,
                   "'file' must be a file that can be read, found 'nowhere.stl'");
  expect_no_sleeve(" file tube.obj" + platens + material,
                   "'file' must end in .stl, .vtk or .vtp, found 'tube.obj'");
  expect_no_sleeve(" file in.stl" + platens + material, "'file' must be a file that can be read");
}

TEST(Sleeve, RefusesAMeshWithoutASize)
{
  expect_no_sleeve(" cylinder 0.05 0.2 0 edge 0.02" + platens + material,
                   "height of the sleeve must be larger than 0, found -0.2: write a length in m");
  expect_no_sleeve(" cylinder 0.05 0 0.2 edge 0" + platens + material,
                   "'edge' must be larger than zero, found 0");
}

TEST(Sleeve, RefusesHalfAnOrthotropicMaterial)
{
  expect_no_sleeve(mesh + platens + material + " modulus_axial 5e6",
                   "shear_modulus of an orthotropic shell must be larger than 0, found 0");
  expect_no_sleeve(mesh + platens + material + " shear_modulus 5e6",
                   "'shear_modulus' goes with 'modulus_axial', found it alone, give both or "
                   "neither");
}

TEST(Sleeve, RefusesAStripTableThatIsNone)
{
  const TemporaryFolder folder;
  const auto expect_no_table = [&](const std::string& text, const std::string& sentence) {
    const std::string path = folder.path() / "strip.csv";
    std::ofstream(path) << text;
    expect_no_sleeve(mesh + platens + material + " strip " + path, sentence);
  };
  const std::string header = "strain [-],hoop_tension [N/m],axial_tension [N/m]\n";
  expect_no_sleeve(mesh + platens + material + " strip nowhere.csv",
                   "'strip' must name a CSV file that can be read, found 'nowhere.csv'");
  expect_no_table("strain,tension\n0,0\n",
                  "must start with the line 'strain [-],hoop_tension "
                  "[N/m],axial_tension [N/m]', found 'strain,tension'");
  expect_no_table(header + "0,0,0\n0.02,2300\n", "must have 3 values, found 2");
  expect_no_table(header + "0,0,0\n", "needs two rows or more, found 1");
  expect_no_table(header + "0.01,0,0\n0.02,2300,2300\n",
                  "must start at 0 strain and 0 hoop tension, found 0.01 and 0 N/m");
  expect_no_table(
      header + "0,0,0\n0.02,2300,2300\n0.02,2400,2400\n",
      "must have strains that increase from row to row, found 0.02 after 0.02 in row 3");
  expect_no_table(header + "0,0,0\n0.02,2300,-2300\n",
                  "must have no negative tension, found -2300 N/m in the axial direction in row 2");
  expect_no_table(header + "0,0,0\n0.02,3000,3000\n",
                  "'modulus' times 'thickness' must be at least the steepest slope of the table of "
                  "'strip', found 115000 N/m and 150000 N/m in the hoop direction");
}

TEST(Sleeve, RefusesAStrengthThatMeansNothing)
{
  const TemporaryFolder folder;
  const std::string path = folder.path() / "strip.csv";
  std::ofstream(path) << "strain [-],hoop_tension [N/m],axial_tension [N/m]\n0,0,0\n"
                         "0.08,9200,9200\n";
  const std::string sleeve = mesh + platens + material;
  for (const std::string after : {"warn", "yield"})
    expect_no_sleeve(sleeve + " strip " + path + " strength 6.5e3 9.2e3 after_strength " + after,
                     "the 'strength' must not be below the last tension of the table of 'strip' "
                     "unless the cloth tears there, found 6500 and 9200 N/m in the hoop direction");
  expect_no_sleeve(sleeve + " strength 9.2e3 0",
                   "'strength' must be larger than zero in both "
                   "directions, found 0");
  expect_no_sleeve(
      sleeve + " after_strength yield",
      "'after_strength' goes with 'strength', found 'after_strength yield' without it");
  const std::string strong = sleeve + " strength 9.2e3 9.2e3";
  expect_no_sleeve(strong + " after_strength yield hardening -1",
                   "'hardening' must be zero or larger, found -1");
  expect_no_sleeve(
      strong + " hardening 5e3",
      "'hardening' goes with 'after_strength yield', found 'hardening 5e3' without it");
  expect_no_sleeve(strong + " after_strength yield hardening 2e5",
                   "'hardening' must be less than 'modulus' times 'thickness', found 200000 and "
                   "115000 N/m in the hoop direction");
  for (const std::string energy : {"0", "-100"})
    expect_no_sleeve(strong + " after_strength tear fracture_energy " + energy,
                     "'fracture_energy' must be larger than zero, found " + energy);
  expect_no_sleeve(
      strong + " after_strength tear fracture_energy 5",
      "facets of a cloth that tears must be narrower than 2 G_f J / N_u^2 = 0.013587 m "
      "in the hoop direction, or they snap back, found 0.0");
  for (const std::string seam : {"0", "-0.5", "1.2"})
    expect_no_sleeve(strong + " seam " + seam,
                     "'seam' must be larger than 0 and at most 1, found " + seam);
  expect_no_sleeve(strong + " seam_angle 90", "'seam_angle' goes with 'seam'");
  expect_no_sleeve(strong + "\nfix_modify side strength 1e3 1e3",
                   "'strength' cannot be changed by 'fix_modify'");
}

TEST(Sleeve, RefusesATypeTheBoxDoesNotHave)
{
  expect_no_sleeve(mesh + " type 3 platens top bottom" + material,
                   "'type' must be one of the 2 atom types, found 3");
}

TEST(Sleeve, RefusesAWallOfAnotherLawThanThePairs)
{
  expect_no_sleeve(mesh + platens + material,
                   "'model' must be that of the pair style for a wall of sleeves, 'linear "
                   "tangential history', found 'linear tangential history rolling_friction epsd2', "
                   "write 'model linear tangential history'",
                   "fix wall all wall/gran model linear tangential history rolling_friction epsd2 "
                   "mesh n_meshes 1 meshes side\n");
}

// The host casts whatever bears the name to a mesh of its own, and ends in a segmentation fault.
TEST(Sleeve, IsRefusedByEveryCommandOfTheHostThatTakesAMesh)
{
  const std::string sleeve = "fix side all mesh/surface/shell" + mesh + platens + material + walls;
  for (const std::string line :
       {"dump d all mesh/stl 50 s*.stl side", "dump d all stl 50 s*.stl side",
        "dump d all mesh/vtk 50 s*.vtk id side", "dump d all mesh/gran/VTK 50 s*.vtk side id",
        "dump d all mesh/vtm 50 s*.vtm meshes side mesh_properties id",
        "fix f all contacthistory/mesh side", "fix f all contactproperty/atom/wall mesh side",
        "fix f all insert/stream seed 5330 distributiontemplate none nparticles 5 insert_every "
        "once "
        "extrude_length 0.1 insertion_face side",
        "fix f all massflow/mesh mesh side vec_side 0 0 -1",
        "fix f all massflow/mesh/sieve mesh side", "fix f all move/mesh mesh side linear 0 0 1",
        "fix f all neighlist/mesh side"}) {
    const Outcome outcome =
        run_deck(opening_deck("empty_cylinder") + grain + sleeve + line + "\n", 1);
    EXPECT_EQ(outcome.exit_code, 1) << line;
    EXPECT_TRUE(
        outcome.says("takes a mesh of the host, found 'side', which is a 'fix "
                     "mesh/surface/shell', "))
        << line << "\n"
        << outcome.output;
  }
}

TEST(Sleeve, LeavesTheMeshesOfTheHostToItsCommands)
{
  const TemporaryFolder folder;
  const std::string sleeve = "fix side all mesh/surface/shell" + mesh + platens + material + walls;
  const Outcome outcome =
      run_deck(opening_deck("empty_cylinder") + grain + sleeve +
                   "create_wall_mesh file plate.stl shape square half_width 0.01 z 0.01 edge 0.01\n"
                   "fix plate all mesh/surface file plate.stl type 2\n"
                   "dump d all mesh/stl 1 s*.stl plate\nrun 1\n",
               1, folder.path());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "s1.stl"));
}

TEST(Sleeve, RefusesAWallThatDoesNotCountItsMeshes)
{
  expect_no_sleeve(mesh + platens + material,
                   "a wall with sleeves is written 'mesh n_meshes N meshes ID ...', found 'mesh "
                   "meshes side', write for example 'mesh n_meshes 1 meshes side'",
                   "fix wall all wall/gran model linear tangential history mesh meshes side\n");
}

TEST(Sleeve, RefusesToChangeItsMaterialLater)
{
  expect_no_sleeve(mesh + platens + material,
                   "'thickness' cannot be changed by 'fix_modify', found 'thickness 0.02', give it "
                   "on the fix line",
                   "fix_modify side thickness 0.02\n");
}

TEST(Sleeve, RefusesAStepTooLongForTrueMasses)
{
  expect_no_sleeve(mesh + platens + material + " mass_scaling no",
                   "the step of 1 s is longer than the sleeve's stable ");
}

TEST(Sleeve, RefusesAGrainOutsideIt)
{
  expect_no_sleeve(mesh + platens + material, "grain 2 is on the wrong side of facet ",
                   "create_atoms 1 single 0.053 0 0.1 units box\n"
                   "set group all diameter 0.01 density 2500\n");
}

// Here the run has begun: what counts is that it ends, with the reason.
TEST(Sleeve, EndsTheRunWhenItIsStrainedBeyondItsLimit)
{
  for (const int ranks : {1, 2}) {
    const Outcome outcome = run_deck(
        opening_deck("empty_cylinder") + grain + "fix side all mesh/surface/shell" + mesh +
            platens + material + " pressure -200e3 strain_limit 0.05" + walls + "run 4000\n",
        ranks);
    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_TRUE(
        outcome.says(", the 'strain_limit' is 0.05, slow the loading, look at the sleeve "
                     "there or write a larger limit"))
        << outcome.output;
  }
}
