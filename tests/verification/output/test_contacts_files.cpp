// SPDX-License-Identifier: GPL-2.0-only
// The files of `fix output/contacts`, read back: forces known in closed form, and those of a
// specimen against the host's own list of contacts.
#include "restart/specimen_deck.h"
#include "support/csv_table.h"
#include "verification/lattice/contact_list.h"
#include "verification/output/vtp_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const double pi = std::acos(-1.0), modulus = 7e6, radius = 0.01;
/// pi r^2 E* / (2 r) 0.2 mm between grains, pi r E* 0.1 mm at a wall: the same.
const double force = pi * radius * modulus * 1e-4;

/// Runs `deck` in `folder`.
void run_in(const fs::path& folder, const std::string& deck, int ranks = 1)
{
  const Outcome outcome = run_deck(deck, ranks, folder);
  if (outcome.exit_code != 0) throw std::runtime_error(outcome.output);
}

/// Grain 2 stands on grain 1, the border of two ranks between them, and grain 1 on a platen.
std::string pile(const std::string& rest)
{
  return opening_deck("empty_cylinder") +
         "create_atoms 1 single 0 0 0.0901 units box\n"
         "create_atoms 1 single 0 0 0.1099 units box\n"
         "set group all diameter 0.02 density 2500\n"
         "group upper id 2\n"
         "fix side all servo/cylinder radius 0.05 platens top bottom type 2\n"
         "fix top all servo/platen position top z 0.15 side side type 2\n"
         "fix bottom all servo/platen position bottom z 0.0802 side side type 2\n"
         "fix move all nve/sphere\n" +
         rest;
}

const std::string chains = "fix chains all output/contacts every 1 rows 1 folder contacts ";

void expect_near(const std::vector<double>& found, const std::vector<double>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t n = 0; n < found.size(); ++n)
    EXPECT_NEAR(found[n], expected[n], 3e-7 * (1.0 + std::abs(expected[n]))) << "number " << n;
}

fs::path consolidated_file(const fs::path& folder)
{
  static const TemporaryFolder kept;
  static const bool made = [] {
    run_in(kept.path(), new_specimen("run 1000\nunfix grow\nfix_modify side servo 50e3 ramp 1000\n"
                                     "fix_modify bottom servo 50e3 ramp 1000\nrun 2000\n"
                                     "write_restart consolidated\n"));
    return true;
  }();
  EXPECT_TRUE(made);
  fs::copy(kept.path() / "consolidated", folder / "consolidated");
  return "consolidated";
}

}  // namespace

TEST(ContactsFile, HoldsALineForEveryContactOnOneAndOnTwoRanks)
{
  for (const int ranks : {1, 2}) {
    const TemporaryFolder folder;
    run_in(folder.path(), pile(chains + "\nrun 0\n"), ranks);
    const VtpFile file(folder.path() / "contacts/contacts_000000000.vtp");
    ASSERT_EQ(file.data()->GetNumberOfLines(), 2);
    ASSERT_EQ(file.data()->GetNumberOfPoints(), 4);
    // sorted by grains: the wall of grain 1, then grain 1 and 2
    expect_near(file.point(0), {0.0, 0.0, 0.0901});
    expect_near(file.point(1), {0.0, 0.0, 0.0802});
    expect_near(file.point(2), {0.0, 0.0, 0.0901});
    expect_near(file.point(3), {0.0, 0.0, 0.1099});
    expect_near(file.of_cells("kind [-]"), {1.0, 0.0});
    expect_near(file.of_cells("normal_force [N]"), {force, force});
    expect_near(file.of_cells("shear_force [N]"), {0.0, 0.0});
    expect_near(file.of_cells("sliding [-]"), {0.0, 0.0});
    expect_near(file.of_points("force [N]"), {force, force, force, force});
  }
}

// The upper grain moves sideways: by 10 nm in a step, where the shear spring k_t = k_n bears it,
// or by 0.1 mm, where it would bear 11 N and friction gives half of the normal force.
TEST(ContactsFile, TellsShearForceAndSliding)
{
  const double stiffness = 0.5 * pi * radius * modulus;
  for (const double speed : {1e-3, 20.0}) {
    const TemporaryFolder folder;
    run_in(folder.path(), pile("velocity upper set " + std::to_string(speed) + " 0 0 units box\n" +
                               chains + "\nrun 1\n"));
    const VtpFile file(folder.path() / "contacts/contacts_000000001.vtp");
    ASSERT_EQ(file.data()->GetNumberOfLines(), 2);
    const double normal = file.of_cells("normal_force [N]")[1];
    const double shear = file.of_cells("shear_force [N]")[1];
    const bool slides = speed > 1.0;
    EXPECT_NEAR(shear / (slides ? 0.5 * normal : stiffness * speed * 1e-5), 1.0, 1e-3);
    EXPECT_EQ(file.of_cells("sliding [-]")[1], slides ? 1.0 : 0.0);
    EXPECT_NEAR(file.of_points("force [N]")[2], std::hypot(normal, shear), 1e-6 * normal);
  }
}

TEST(ContactsFile, KnowsASleeve)
{
  const TemporaryFolder folder;
  run_in(folder.path(),
         opening_deck("empty_cylinder") +
             "create_atoms 1 single 0 0.0455 0.1 units box\n"
             "set group all diameter 0.01 density 2500\n"
             "fix side all mesh/surface/shell cylinder 0.05 0 0.2 edge 0.01 type 2 platens top "
             "bottom modulus 11.5e6 poisson 0.3 thickness 0.01 density 30 rigid yes\n"
             "fix top all servo/platen position top z 0.2 side side type 2\n"
             "fix bottom all servo/platen position bottom z 0 side side type 2\n"
             "fix move all motion step 1.0\n" +
             chains + "\nrun 0\nvariable force equal fy[1]\nprint \"force ${force}\"\n");
  const VtpFile file(folder.path() / "contacts/contacts_000000000.vtp");
  ASSERT_EQ(file.data()->GetNumberOfLines(), 1);
  EXPECT_EQ(file.of_cells("kind [-]").front(), 2.0);
  const double length = file.point(1)[1] - file.point(0)[1];
  const double overlap = 0.005 - length;
  EXPECT_NEAR(file.point(1)[1], 0.05, 5e-4) << "a polygon within the circle";
  EXPECT_LT(file.point(1)[1], 0.05);
  const double pressed = file.of_cells("normal_force [N]").front();
  EXPECT_NEAR(pressed, pi * 0.005 * modulus * overlap, 0.2 * pressed) << "stiffer on an edge";
  const CsvTable table(folder.path() / "contacts.csv");
  EXPECT_EQ(table.column("sleeve_contacts [-]").front(), 1.0);
  EXPECT_EQ(table.column("wall_contacts [-]").front(), 0.0);
}

TEST(ContactsFile, LeavesOutWhatBearsLessThanTheThresholdButCountsIt)
{
  const TemporaryFolder folder;
  run_in(folder.path(), pile(chains + "threshold 22 level 21.9 level 22\nrun 0\n"), 2);
  const VtpFile file(folder.path() / "contacts/contacts_000000000.vtp");
  EXPECT_EQ(file.data()->GetNumberOfLines(), 0);
  const CsvTable table(folder.path() / "contacts.csv");
  ASSERT_EQ(table.rows(), 1u);
  EXPECT_EQ(table.column("contacts [-]").front(), 2.0);
  EXPECT_EQ(table.column("grain_contacts [-]").front(), 1.0);
  EXPECT_EQ(table.column("wall_contacts [-]").front(), 1.0);
  EXPECT_NEAR(table.column("mean_force [N]").front(), force, 1e-6);
  EXPECT_NEAR(table.column("largest_force [N]").front(), force, 1e-6);
  EXPECT_EQ(table.column("contacts_above_21.9N [-]").front(), 2.0);
  EXPECT_EQ(table.column("share_above_21.9N [-]").front(), 1.0);
  EXPECT_EQ(table.column("contacts_above_22N [-]").front(), 0.0);
}

// The host's own list of a specimen of some 230 grains, with forces as vectors.
TEST(ContactsFile, HoldsTheContactsOfTheHostsList)
{
  const TemporaryFolder folder;
  run_in(folder.path(), specimen_of(consolidated_file(folder.path()),
                                    find_contacts + chains + "\nrun 0\n" + write_contacts));
  std::vector<GrainContact> expected = contacts_in(folder.path());
  const std::vector<Grain> grains = grains_in(folder.path());
  ASSERT_GT(expected.size(), 400u);
  for (GrainContact& c : expected)
    if (c.i > c.j) c = {c.j, c.i, -c.branch, -c.force_i};
  std::sort(expected.begin(), expected.end(), [](const GrainContact& a, const GrainContact& b) {
    return std::pair(a.i, a.j) < std::pair(b.i, b.j);
  });

  const VtpFile file(folder.path() / "contacts/contacts_000003000.vtp");
  const auto kind = file.of_cells("kind [-]"), normal = file.of_cells("normal_force [N]"),
             shear = file.of_cells("shear_force [N]");
  std::size_t next = 0;
  for (std::size_t n = 0; n < kind.size(); ++n) {
    if (kind[n] != 0.0) continue;
    ASSERT_LT(next, expected.size());
    const GrainContact& c = expected[next++];
    const Vec3 along = c.branch.normalized();
    const double size = c.force_i.norm() + 1.0;
    EXPECT_NEAR(normal[n], -c.force_i.dot(along), 1e-6 * size);
    EXPECT_NEAR(shear[n], (c.force_i - c.force_i.dot(along) * along).norm(), 1e-6 * size);
    const int from = static_cast<int>(2 * n);
    for (int a = 0; a < 3; ++a) {
      EXPECT_NEAR(file.point(from)[a], grains[c.i - 1].center[a], 1e-8);
      EXPECT_NEAR(file.point(from + 1)[a], grains[c.j - 1].center[a], 1e-8);
    }
  }
  EXPECT_EQ(next, expected.size());
}

TEST(ContactsFile, IsTheSameOnOneTwoAndFourRanks)
{
  std::vector<double> kind, normal, shear;
  for (const int ranks : {1, 2, 4}) {
    const TemporaryFolder folder;
    run_in(folder.path(), specimen_of(consolidated_file(folder.path()), chains + "\nrun 0\n"),
           ranks);
    const VtpFile file(folder.path() / "contacts/contacts_000003000.vtp");
    if (ranks == 1) {
      kind = file.of_cells("kind [-]");
      normal = file.of_cells("normal_force [N]");
      shear = file.of_cells("shear_force [N]");
      EXPECT_GT(std::count(kind.begin(), kind.end(), 1.0), 50);
    }
    EXPECT_EQ(file.of_cells("kind [-]"), kind);
    const auto normals = file.of_cells("normal_force [N]"),
               shears = file.of_cells("shear_force [N]");
    ASSERT_EQ(normals.size(), normal.size());
    for (std::size_t n = 0; n < normal.size(); ++n) {
      EXPECT_NEAR(normals[n], normal[n], 1e-6 * (1.0 + normal[n]));
      EXPECT_NEAR(shears[n], shear[n], 1e-6 * (1.0 + normal[n]));
    }
    const CsvTable table(folder.path() / "contacts.csv");
    EXPECT_EQ(table.column("contacts [-]").front(), static_cast<double>(kind.size()));
    double sum = 0.0, most = 0.0, above = 0.0;
    for (std::size_t n = 0; n < normal.size(); ++n) {
      const double size = std::hypot(normal[n], shear[n]);
      sum += size;
      most = std::max(most, size);
      above += size >= 5.0;
    }
    EXPECT_NEAR(table.column("mean_force [N]").front(), sum / kind.size(), 1e-5 * most);
    EXPECT_NEAR(table.column("largest_force [N]").front(), most, 1e-5 * most);
    EXPECT_EQ(table.column("contacts_above_5N [-]").front(), above);
  }
}

TEST(ContactsFile, GoesOnAfterARestartAsIfTheRunHadNotStopped)
{
  const std::string output =
      "fix chains all output/contacts every 20 rows 10 folder contacts threshold 5\n";
  const TemporaryFolder whole, parts;
  const fs::path begin = consolidated_file(whole.path());
  consolidated_file(parts.path());
  run_in(whole.path(), specimen_of(begin, output + "run 30\nrun 30\n"));
  run_in(parts.path(), specimen_of(begin, output + "run 30\nwrite_restart stop\nrun 10\n"));
  run_in(parts.path(), specimen_of("stop", output + "run 30\n"));
  EXPECT_EQ(read_text(parts.path() / "contacts.csv"), read_text(whole.path() / "contacts.csv"));
  EXPECT_EQ(read_text(parts.path() / "contacts/contacts.pvd"),
            read_text(whole.path() / "contacts/contacts.pvd"));
  EXPECT_EQ(read_text(parts.path() / "contacts/contacts_000003060.vtp"),
            read_text(whole.path() / "contacts/contacts_000003060.vtp"));
  EXPECT_EQ(listed_in(whole.path() / "contacts/contacts.pvd").size(), 4u);
  EXPECT_EQ(CsvTable(whole.path() / "contacts.csv").rows(), 7u);
}
