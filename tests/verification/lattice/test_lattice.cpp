// SPDX-License-Identifier: GPL-2.0-only
// Lattices of equal spheres with the same overlap at every contact.
#include "measure/sphere_overlap.h"
#include "verification/lattice/contact_list.h"

#include <gtest/gtest.h>

#include <map>

using namespace encased_column;
using namespace encased_column::testing;
namespace fs = std::filesystem;

namespace {

const double radius = 0.01, modulus = 7e6, overlap = 2e-5;
const double distance = 2.0 * radius - overlap;
const double stiffness = 0.5 * pi * radius * modulus;
const double force = stiffness * overlap;

std::string digits(double x)
{
  std::ostringstream text;
  text.precision(17);
  text << x;
  return text.str();
}

std::string grains_at(const std::vector<Vec3>& points)
{
  std::string deck;
  for (const Vec3& p : points)
    deck += "create_atoms 1 single " + digits(p.x()) + " " + digits(p.y()) + " " + digits(p.z()) +
            " units box\n";
  return deck + "set group all diameter 0.02 density 2500\n";
}

/// Motion and history of what stands between two platens; the cylinder is far away.
std::string specimen(double low, double high)
{
  return "fix side all servo/cylinder radius 0.09 platens top bottom type 2\n"
         "fix top all servo/platen position top z " +
         digits(high) + " area 1 type 2\nfix bottom all servo/platen position bottom z " +
         digits(low) +
         " area 1 type 2\nfix move all motion damping 0.7\n"
         "fix history all specimen/history platens top bottom side side motion move every 50\n";
}

std::string print_history(const std::string& name, int column)
{
  return "variable " + name + " equal f_history[" + std::to_string(column) + "]\nprint \"" + name +
         " ${" + name + "}\"\n";
}

/// Runs a deck without grains' motion and leaves contacts and grains in `folder`.
Outcome look_at(const std::string& deck, const fs::path& folder)
{
  const Outcome outcome =
      run_deck(opening_deck("empty_cylinder") + find_contacts + deck + write_contacts +
                   print_history("porosity", 12) + print_history("porosity_less_overlap", 13) +
                   print_history("coordination", 14),
               1, folder);
  if (outcome.exit_code != 0) throw std::runtime_error(outcome.output);
  return outcome;
}

double volume_between_platens(double height)
{
  return pi * 0.09 * 0.09 * height;
}

/// 4 x 4 x 4 spheres in a box of six walls. A wall is twice as stiff as a grain: half the overlap
/// gives the same force, and the walls stand half a distance from the outer centers.
class SimpleCubic : public ::testing::Test {
 protected:
  static constexpr int n = 4;
  static double width() { return n * distance; }

  static std::string block()
  {
    std::vector<Vec3> points;
    for (int x = 0; x < n; ++x)
      for (int y = 0; y < n; ++y)
        for (int z = 0; z < n; ++z) points.push_back(distance * Vec3(x - 1.5, y - 1.5, z + 0.5));
    std::string deck = grains_at(points);
    for (const char* plane : {"xplane", "yplane"})
      for (const double sign : {-1.0, 1.0})
        deck += std::string("fix ") + plane + (sign < 0 ? "_low" : "_high") +
                " all wall/gran model linear tangential history primitive type 2 " + plane + " " +
                digits(0.5 * sign * width()) + "\n";
    return deck + specimen(0.0, width());
  }
};

}  // namespace

TEST_F(SimpleCubic, HasSixContactsOfTheSameForceAtEveryGrain)
{
  const TemporaryFolder folder;
  const Outcome outcome = look_at(block(), folder.path());
  EXPECT_EQ(outcome.value("coordination"), 6.0);
  const auto contacts = contacts_in(folder.path());
  EXPECT_EQ(contacts.size(), 3u * n * n * (n - 1));
  for (const GrainContact& c : contacts) {
    EXPECT_NEAR((c.force_i + force * c.branch.normalized()).norm(), 0.0, 1e-9 * force);
  }
  for (const Grain& grain : grains_in(folder.path()))
    EXPECT_NEAR(grain.force.norm(), 0.0, 1e-9 * force);
}

// Porosity of a cube per sphere, 1 - pi / 6 (2 r / d)^3; the lenses are taken out once each.
TEST_F(SimpleCubic, HasThePorosityOfASphereInItsCube)
{
  const TemporaryFolder folder;
  const Outcome outcome = look_at(block(), folder.path());
  const double around = volume_between_platens(width());
  const double solid = (1.0 - outcome.value("porosity")) * around;
  const double cube = std::pow(2.0 * radius * n, 3);
  EXPECT_NEAR(1.0 - solid / cube, 0.476401, 5e-7);
  const double shared =
      (outcome.value("porosity_less_overlap") - outcome.value("porosity")) * around;
  const double lens = pi * overlap * overlap * (6.0 * radius - overlap) / 12.0;
  const double cap = pi * std::pow(overlap / 2.0, 2) * (3.0 * radius - overlap / 2.0) / 3.0;
  const double expected = 3.0 * n * n * (n - 1) * lens + 6.0 * n * n * cap;
  EXPECT_NEAR(shared, expected, 1e-6 * expected);
}

// Each wall carries n^2 contacts; (1/V) sum f x over the walls is F / d^2 along every axis, and so
// is the Love-Weber sum over pairs and walls (arm d / 2).
TEST_F(SimpleCubic, CarriesTheSamePressureAtItsWallsAndByLoveWeber)
{
  const TemporaryFolder folder;
  const Outcome outcome =
      look_at(block() +
                  "run 0\nvariable top equal f_top[2]\nvariable bottom equal f_bottom[2]\n"
                  "print \"top ${top}\"\nprint \"bottom ${bottom}\"\n",
              folder.path());
  const double pressure = force / (distance * distance);
  const double area = width() * width();
  EXPECT_NEAR(outcome.value("top") / area, pressure, 1e-9 * pressure);
  EXPECT_NEAR(outcome.value("bottom") / area, pressure, 1e-9 * pressure);
  const Mat3 pairs = love_weber_sum(contacts_in(folder.path())) / std::pow(width(), 3);
  const double walls = 2.0 * n * n * force * 0.5 * distance / std::pow(width(), 3);
  const Mat3 expected = pressure * Mat3::Identity();
  EXPECT_NEAR((pairs + walls * Mat3::Identity() - expected).norm(), 0.0, 1e-9 * pressure);
  // F / (4 r^2) for grains that just touch
  EXPECT_NEAR(pressure, force / (4.0 * radius * radius), 3e-3 * pressure);
}

// Balls in the middle, across one wall and across an edge of three: every grain bears F / d^2 times
// the volume d^3 of its cube, at walls as elsewhere, so that of the pressure a ball finds the part
// that its solid has of a full lattice's. The contact with a wall lies overlap / 4 further out, in
// the middle of an overlap half as large.
TEST_F(SimpleCubic, HasThatPressureInBallsThatCutItsWalls)
{
  const double pressure = force / (distance * distance), ball = 0.025;
  const double solid = sphere_volume(radius) / std::pow(distance, 3);
  for (const Vec3& center :
       {Vec3(0.0, 0.0, 0.04), Vec3(0.035, 0.002, 0.04), Vec3(0.03, -0.032, 0.01)}) {
    const TemporaryFolder folder;
    std::string lines = "fix ball all measure/sphere sphere " + digits(center.x()) + " " +
                        digits(center.y()) + " " + digits(center.z()) + " " + digits(ball) +
                        "\nrun 0\n";
    for (const auto& [name, column] :
         {std::pair("empty", 8), std::pair("xx", 15), std::pair("yy", 16), std::pair("zz", 17),
          std::pair("xy", 18), std::pair("ends", 10)})
      lines += std::string("variable ") + name + " equal f_ball[1][" + std::to_string(column) +
               "]\nprint \"" + name + " ${" + name + "}\"\n";
    const Outcome outcome =
        run_deck(opening_deck("empty_cylinder") + block() + lines, 1, folder.path());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_EQ(outcome.value("ends"), 6.0) << "walls are contacts";
    const double expected = pressure * (1.0 - outcome.value("empty")) / solid;
    EXPECT_LT(expected, 1.2 * pressure);
    const double tolerance = center.x() == 0.0 ? 1e-9 : overlap / (4.0 * radius);
    for (const char* name : {"xx", "yy", "zz"})
      EXPECT_NEAR(outcome.value(name), expected, tolerance * pressure) << name;
    EXPECT_NEAR(outcome.value("xy"), 0.0, 1e-9 * pressure);
  }
}

// C11 = k_n / (2 r): columns of springs side by side, held at their sides without friction.
TEST_F(SimpleCubic, HasTheAxialModulusOfItsSprings)
{
  const double strain = 1e-4;
  const Outcome outcome = run_deck(
      opening_deck("empty_cylinder") +
      "unfix friction\n"
      "fix friction all property/global coefficientFriction peratomtypepair 2 0.5 0 0 0\n" +
      block() +
      "run 0\n"
      "variable before equal f_top[2]\nvariable a equal ${before}\n"
      "variable speed equal " +
      digits(strain * width()) +
      "/(1000*dt)\nvariable v equal ${speed}\n"
      "fix_modify top velocity ${v}\nrun 1000\n"
      "fix_modify top hold\nsolve ratio average 1e-9\n"
      "variable more equal f_top[2]-v_a\nprint \"more ${more}\"\n"
      "variable way equal " +
      digits(width()) + "-f_top[3]\nprint \"way ${way}\"\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const double moved = outcome.value("way") / width();
  EXPECT_NEAR(moved, strain, 0.01 * strain);
  const double stress = outcome.value("more") / (width() * width());
  const double expected = stiffness / distance;
  EXPECT_NEAR(stress / moved, expected, 1e-5 * expected);
  EXPECT_NEAR(expected, pi * modulus / 4.0, 2e-3 * expected);
}

namespace {

/// 3 x 3 x 3 cells of the face-centered cubic lattice, in free space.
std::vector<Vec3> face_centered_cubic()
{
  const double cell = std::sqrt(2.0) * distance;
  std::vector<Vec3> points;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z)
        for (const Vec3& site :
             {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0.5, 0, 0.5), Vec3(0, 0.5, 0.5)})
          points.push_back(cell * (Vec3(x, y, z) + site - Vec3(1.25, 1.25, 0)) + Vec3(0, 0, 0.05));
  return points;
}

}  // namespace

// Around an inner grain: twelve forces F along the diagonals of the faces; its part of the lattice
// has the volume d^3 / sqrt 2 and half of each branch.
TEST(FaceCenteredCubic, HasTwelveContactsAndTheirPressureAtEveryInnerGrain)
{
  const TemporaryFolder folder;
  look_at(grains_at(face_centered_cubic()) + specimen(0.0, 0.2), folder.path());
  std::map<int, std::vector<GrainContact>> contacts_of;
  for (const GrainContact& c : contacts_in(folder.path())) {
    EXPECT_NEAR(c.force_i.norm(), force, 1e-9 * force);
    contacts_of[c.i].push_back(c);
    contacts_of[c.j].push_back(c);
  }
  const auto grains = grains_in(folder.path());
  const double volume = std::pow(distance, 3) / std::sqrt(2.0);
  const double pressure = 2.0 * std::sqrt(2.0) * force / (distance * distance);
  int inner = 0;
  for (const auto& [id, contacts] : contacts_of) {
    EXPECT_LE(contacts.size(), 12u);
    if (contacts.size() < 12) continue;
    ++inner;
    EXPECT_NEAR(grains[id - 1].force.norm(), 0.0, 1e-9 * force);
    const Mat3 stress = 0.5 * love_weber_sum(contacts) / volume;
    EXPECT_NEAR((stress - pressure * Mat3::Identity()).norm(), 0.0, 1e-9 * pressure);
  }
  EXPECT_EQ(inner, 32);
  EXPECT_NEAR(pressure, force / (std::sqrt(2.0) * radius * radius), 3e-3 * pressure);
}

TEST(FaceCenteredCubic, HasThePorosityOfItsCells)
{
  const TemporaryFolder folder;
  const auto points = face_centered_cubic();
  const Outcome outcome = look_at(grains_at(points) + specimen(0.0, 0.2), folder.path());
  const double around = volume_between_platens(0.2);
  const double solid = (1.0 - outcome.value("porosity")) * around;
  const double cells = 27.0 * std::pow(2.0 * std::sqrt(2.0) * radius, 3);
  EXPECT_NEAR(1.0 - solid / cells, 0.259520, 5e-7);
  const double shared =
      (outcome.value("porosity_less_overlap") - outcome.value("porosity")) * around;
  const double lens = pi * overlap * overlap * (6.0 * radius - overlap) / 12.0;
  const double expected = contacts_in(folder.path()).size() * lens;
  EXPECT_NEAR(shared, expected, 1e-6 * expected);
  EXPECT_NEAR(outcome.value("coordination"),
              2.0 * contacts_in(folder.path()).size() / static_cast<double>(points.size()), 1e-12);
}
