// SPDX-License-Identifier: GPL-2.0-only
// A specimen of some 200 grains at rest between servo walls: what the walls say, what the contacts
// say.
#include "measure/sphere_overlap.h"
#include "verification/lattice/contact_list.h"

#include <gtest/gtest.h>

using namespace encased_column;
using namespace encased_column::testing;

namespace {

const double modulus = 7e6, confining = 50e3, axial = 80e3;

/// Radii grow to a loose packing; walls without friction then press it, along the axis more than
/// around.
const std::string pressed_specimen = R"(
unfix          friction
fix            friction all property/global coefficientFriction peratomtypepair 2 0.3 0 0 0
create_packing gradation )" ENCASE_SOURCE
                                     R"(/input_scripts/common/gradation_cinder_gravel.csv &
  distribution uniform_number finest 5e-3 cylinder 0.025 0 0.05 porosity 0.38 density 1738 type 1 seed 3 start_factor 0.5
fix            side all servo/cylinder radius 0.025 platens top bottom type 2
fix            top all servo/platen position top z 0.05 side side type 2
fix            bottom all servo/platen position bottom z 0 side side type 2
fix            move all motion damping 0.7 step 1.0
fix            grow all grow/radius from 0.5 stages 50 relax 20
thermo         1000
run            1000
unfix          grow
fix_modify     side servo 50e3 ramp 1000
fix_modify     top servo 80e3 ramp 1000
fix_modify     bottom servo 80e3 ramp 1000
fix            history all specimen/history platens top bottom side side motion move every 200
solve          ratio average 1e-6 least 4000
fix            ball all measure/sphere sphere 0 0 0.025 0.06
run            0
variable       ball_axial equal f_ball[1][12]
variable       ball_around equal 0.5*(f_ball[1][13]+f_ball[1][14])
variable       ball_grains equal f_ball[1][7]
print          "ball_axial ${ball_axial}"
print          "ball_around ${ball_around}"
print          "ball_grains ${ball_grains}"
variable       high equal f_top[3]
variable       low equal f_bottom[3]
variable       radius equal f_side[3]
variable       coordination equal f_history[14]
variable       less equal f_history[13]-f_history[12]
print          "high ${high}"
print          "low ${low}"
print          "radius ${radius}"
print          "coordination ${coordination}"
print          "less ${less}"
)";

/// The contact of a grain with a wall without friction, found again from where both are.
struct WallContact {
  double overlap, force, arm;
};

WallContact wall_contact(double radius, double distance)
{
  const double overlap = std::max(0.0, radius - distance);
  return {overlap, pi * radius * modulus * overlap, distance};
}

struct Found {
  Outcome outcome;
  std::vector<Grain> grains;
  std::vector<GrainContact> contacts;
  double high, low, radius;
  double volume() const { return pi * radius * radius * (high - low); }
};

const Found& found()
{
  static const Found specimen = [] {
    const TemporaryFolder folder;
    const Outcome outcome =
        run_deck(opening_deck("empty_cylinder") + find_contacts + pressed_specimen + write_contacts,
                 1, folder.path());
    if (outcome.exit_code != 0) throw std::runtime_error(outcome.output);
    return Found{outcome,
                 grains_in(folder.path()),
                 contacts_in(folder.path()),
                 outcome.value("high"),
                 outcome.value("low"),
                 outcome.value("radius")};
  }();
  return specimen;
}

template <typename Act>
void for_each_wall_contact(const Act& act)
{
  const Found& f = found();
  for (const Grain& grain : f.grains) {
    const Vec3& x = grain.center;
    const double outwards = std::hypot(x.x(), x.y());
    act(wall_contact(grain.radius, f.high - x.z()), Vec3(0, 0, 1));
    act(wall_contact(grain.radius, x.z() - f.low), Vec3(0, 0, -1));
    act(wall_contact(grain.radius, f.radius - outwards), Vec3(x.x(), x.y(), 0) / outwards);
  }
}

}  // namespace

// Love-Weber over the contacts of grains and of walls; the walls' own stress is force over area.
// The two agree as far as the grains are in equilibrium.
TEST(BoundaryStress, IsThatOfTheContactsInside)
{
  Mat3 sum = love_weber_sum(found().contacts);
  for_each_wall_contact([&](const WallContact& c, const Vec3& outward) {
    sum += c.force * c.arm * outward * outward.transpose();
  });
  const Mat3 stress = sum / found().volume();
  EXPECT_NEAR(stress(2, 2), axial, 1e-4 * axial);
  EXPECT_NEAR(0.5 * (stress(0, 0) + stress(1, 1)), confining, 1e-4 * confining);
  EXPECT_NEAR((stress - stress.transpose()).norm(), 0.0, 1e-4 * axial) << "moments balance too";
}

// A measuring sphere that cuts all walls and holds every grain: its stress times its volume is the
// sum over the walls of force times place, where a contact lies half an overlap behind the wall;
// that moves it by 0.2 % from the walls' stress times the specimen's volume.
TEST(BoundaryStress, IsThatOfAMeasuringSphereAroundTheSpecimen)
{
  double along = 0.0, around = 0.0;  // N m
  for_each_wall_contact([&](const WallContact& c, const Vec3& outward) {
    const double wall = outward.z() > 0.0   ? found().high
                        : outward.z() < 0.0 ? -found().low
                                            : found().radius;
    const double moment = c.force * (wall + 0.5 * c.overlap);
    (outward.z() == 0.0 ? around : along) += moment;
  });
  const double ball = sphere_volume(0.06);
  EXPECT_EQ(found().outcome.value("ball_grains"), static_cast<double>(found().grains.size()));
  EXPECT_NEAR(found().outcome.value("ball_axial") * ball, along, 1e-4 * along);
  EXPECT_NEAR(found().outcome.value("ball_around") * ball, 0.5 * around, 1e-4 * around);
  EXPECT_NEAR(along, axial * found().volume(), 4e-3 * along);
  EXPECT_NEAR(0.5 * around, confining * found().volume(), 4e-3 * around);
}

TEST(CoordinationNumber, CountsEveryContactOfGrainsAndWalls)
{
  double ends = 2.0 * static_cast<double>(found().contacts.size());
  for_each_wall_contact([&](const WallContact& c, const Vec3&) { ends += c.overlap > 0.0; });
  EXPECT_NEAR(found().outcome.value("coordination"),
              ends / static_cast<double>(found().grains.size()), 1e-9);
}

TEST(PorosityLessOverlap, TakesOutTheLensOfEveryContactAndTheCapBehindEveryWall)
{
  const auto& grains = found().grains;
  double shared = 0.0;
  for (const GrainContact& c : found().contacts)
    shared +=
        sphere_overlap_volume(grains[c.i - 1].radius, grains[c.j - 1].radius, c.branch.norm());
  for_each_wall_contact([&](const WallContact& c, const Vec3&) {
    if (c.overlap > 0.0) shared += sphere_cap_volume(c.arm + c.overlap, c.arm);
  });
  EXPECT_NEAR(found().outcome.value("less") * found().volume(), shared, 1e-6 * shared);
}
