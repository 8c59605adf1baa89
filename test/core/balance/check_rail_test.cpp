// SPDX-License-Identifier: BSD-3-Clause
// A check rail beside the running rail: the flange back touches its face.
#include "core/balance/rail_support.h"
#include "core/profile/curve/spline.h"
#include "core/track/placement.h"
#include "core/track/rail_search.h"
#include "same_bits.h"
#include "wheelset_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double corner_radius = 13e-3;  // [m]
constexpr double steepness = 20;         // of the face, 1:20 from the vertical

/// Check rail with a flat top at the height of the running rail, a corner of 13 mm and a face 1:20, in the coordinates
/// of the running rail. The face begins at `face` [m].
/// @param raised  height of its top above that of the running rail [m]; the face begins higher by the same
std::shared_ptr<const Profile> checkRail(double face, double raised = 0)
{
  const double angle = std::atan(1 / steepness), hypotenuse = std::hypot(1, steepness);
  const double centre = face - corner_radius * std::cos(angle);
  const double corner_end = corner_radius * (std::sin(angle) - 1);
  const double half_turn = std::acos(-1.0);
  const std::vector<ProfileSection> sections{
      {LineSection{centre - 0.04, raised, 1, 0}, 0.04},
      {ArcSection{centre, raised - corner_radius, corner_radius, 0.5 * half_turn, -1},
       corner_radius * (0.5 * half_turn - angle)},
      {LineSection{face, raised + corner_end, 1 / hypotenuse, -steepness / hypotenuse}, 0.020 + raised}};
  return std::make_shared<const Profile>("check rail", sections);
}

constexpr double near_face = -76e-3;  ///< in the coordinates of the left rail [m]

/// 60E1 rails, upright; a check rail beside the rail of one side.
ContactModelConfig withCheckRail(Side side, double face = near_face)
{
  ContactModelConfig config = manchesterScene();
  config.track.rail_inclination = 0;
  const auto running = std::make_shared<const Profile>(rail60E1());
  config.rail_profile = running;
  config.rail_sections[side] = std::make_shared<const RailSections>(
      std::vector<RailSeries>{{{0, running, {}}}, {{0, checkRail(face), {}}}}, RailSections::Placement::coordinates);
  return config;
}

constexpr double point_distance = 20e-6;  // [m]

/// Smallest distance of the flange back from the check rail, with the left wheel at a pose; negative: overlap. By
/// points 20 um apart, without the search.
double clearance(const ContactModelConfig& config, const WheelsetPose& pose)
{
  const PlacedRail rail = restingRail(config, Side::left);
  const PlacedWheel wheel(*config.wheel_profile.left, config.wheelset, Side::left, pose);
  const ParameterRange part = rail.profile().parts().at(1);
  double least = 1;
  for (double u = 0; u < 0.02; u += point_distance)
  {
    PlanePoint on_wheel{};
    if (!wheel.section(wheel.profile().at(u), 0, on_wheel))
    {
      continue;
    }
    for (double v = part.begin + 0.04; v < part.end; v += point_distance)
    {
      const PlanePoint on_rail = rail.at(v);
      const double normal_y = -on_rail.dz, normal_z = on_rail.dy;
      const double along = (on_wheel.y - on_rail.y) * on_rail.dy + (on_wheel.z - on_rail.z) * on_rail.dz;
      if (std::abs(along) < point_distance)
      {
        least = std::min(least, (on_wheel.y - on_rail.y) * normal_y + (on_wheel.z - on_rail.z) * normal_z);
      }
    }
  }
  return least;
}

const PatchResult* steepPatch(const WheelsetResult& result, Side side)
{
  const auto found =
      std::find_if(result.patches.begin(), result.patches.end(),
                   [side](const PatchResult& patch) { return patch.side == side && patch.contact_angle < -1; });
  return found == result.patches.end() ? nullptr : &*found;
}
}  // namespace

// In steps of 10 um, the force of the flange back begins where the undeformed bodies begin to overlap, and grows from
// zero.
TEST(CheckRail, TouchesTheFlangeBackWhereTheBodiesMeet)
{
  const ContactModelConfig config = withCheckRail(Side::left);
  WheelsetContact contact(config);
  constexpr double step = 10e-6;
  double before = 0, first_stiffness = 0;
  int touching = 0;
  for (double y = -2.4e-3; y > -2.9e-3 && touching < 10; y -= step)
  {
    const WheelsetResult& result = okResult(contact, stateAt(y, wheel_load));
    const PatchResult* patch = steepPatch(result, Side::left);
    // The steepest overlap that the points can miss is half of their distance on a radius of 13 mm: below 1 um.
    const double gap = clearance(config, {result.y, result.z, result.yaw, result.roll});
    EXPECT_EQ(patch != nullptr, gap < (patch ? 1e-6 : -1e-6)) << "y " << y << ", gap " << gap;
    const double force = patch ? patch->normal_force : 0;
    EXPECT_GE(force, before) << y;
    // Hertz: the force is proportional to overlap^(3/2). The curvature of the flange back changes along it, and the
    // points miss up to 1 um of the overlap.
    if (gap < -20e-6)
    {
      const double stiffness = force / std::pow(-gap, 1.5);
      EXPECT_NEAR(stiffness, first_stiffness > 0 ? first_stiffness : stiffness, 0.15 * stiffness) << y;
      first_stiffness = first_stiffness > 0 ? first_stiffness : stiffness;
    }
    before = force;
    touching += patch ? 1 : 0;
  }
  EXPECT_EQ(touching, 10);
}

// Vertical and lateral forces of the rail are those of its patches, and the vertical force is the load.
TEST(CheckRail, SharesTheWheelLoadWithTheRunningRail)
{
  WheelsetContact contact(withCheckRail(Side::left));
  contact.evaluate(stateAt(-2.55e-3, wheel_load));
  const WheelsetResult& result = okResult(contact, stateAt(-2.6e-3, wheel_load));
  double vertical = 0, outward = 0;
  for (const PatchResult* patch : patchesOf(result, Side::left))
  {
    vertical += patch->normal_force * std::cos(patch->pose.angle);
    outward += patch->normal_force * std::sin(patch->pose.angle);  // of the force on the rail, along -z of the patch
  }
  EXPECT_NE(steepPatch(result, Side::left), nullptr);
  // The columns of a patch have different normals; its resultant is along their mean.
  EXPECT_NEAR(vertical, wheel_load, 0.01 * wheel_load);
  EXPECT_NEAR(outward, result.rail.left.lateral_force, 0.01 * std::abs(outward));
  EXPECT_LT(result.rail.left.lateral_force, 0);  // the rail is pushed towards the track centre
}

TEST(CheckRail, OnTheRightIsTheMirrorImage)
{
  WheelsetContact left(withCheckRail(Side::left)), right(withCheckRail(Side::right));
  for (const double y : {-2.0e-3, -2.6e-3, -3.0e-3})
  {
    expectMirrorImage(okResult(left, stateAt(y, wheel_load)), okResult(right, stateAt(-y, wheel_load)));
  }
}

// On soft pads, at an angle of attack, and far beyond the first touch, there is a result in every state.
TEST(CheckRail, IsFollowedOnRailsThatBend)
{
  for (const double yaw : {0.0, 5e-3})
  {
    ContactModelConfig config = withCheckRail(Side::left);
    bend(config, softPads());
    WheelsetContact contact(config);
    double before = 0;
    for (double y = -2.0e-3; y > -5e-3; y -= 1e-4)
    {
      const WheelsetResult& result = okResult(contact, stateAt(y, wheel_load, yaw));
      const PatchResult* patch = steepPatch(result, Side::left);
      const double force = patch ? patch->normal_force : 0;
      EXPECT_GE(force, before) << y;  // the pads yield as the wheel moves on
      before = force;
    }
    EXPECT_GT(before, 10e3);
  }
}

// Far from the flange back, the check rail changes nothing but the places at which the outlines are compared.
TEST(CheckRail, OutOfReachChangesNothing)
{
  ContactModelConfig plain = withCheckRail(Side::left);
  plain.rail_sections = nullptr;
  WheelsetContact without(plain), with(withCheckRail(Side::left, near_face - 0.05));
  for (double y = -5e-3; y < 6.5e-3; y += 0.5e-3)
  {
    const WheelsetResult& one = okResult(without, stateAt(y, wheel_load));
    const WheelsetResult& other = okResult(with, stateAt(y, wheel_load));
    EXPECT_EQ(other.patches.size(), one.patches.size()) << y;
    const double pressure = wheelTotal(one, Side::left).max_pressure;
    EXPECT_NEAR(wheelTotal(other, Side::left).max_pressure, pressure, 1e-3 * pressure) << y;  // a tenth of 1 %
    EXPECT_NEAR(other.z, one.z, 1e-7) << y;
  }
}

// Without load, the wheel stands where it first touches, on the check rail or on the running rail.
TEST(CheckRail, AnUnloadedWheelTouchesItWithoutOverlap)
{
  const ContactModelConfig config = withCheckRail(Side::left);
  WheelsetContact contact(config);
  for (double y = -2e-3; y > -6e-3; y -= 0.5e-3)
  {
    const WheelsetResult& result = contact.evaluate(stateAt(y, wheel_load / 2, 0, wheel_load));  // unloads the left
    ASSERT_EQ(result.status, ContactStatus::lift_off) << y << ": " << result.reason;
    // The points miss up to 1 um of an overlap.
    EXPECT_GT(clearance(config, {result.y, result.z, result.yaw, result.roll}), -1e-6) << y;
  }
}

// S1002 begins 9.5 mm below the running circle. The face of a check rail that is 40 mm higher overlaps the wheel only
// where its profile has ended: that is reported, not left out.
TEST(CheckRail, AboveTheEndOfTheWheelProfileIsReported)
{
  ContactModelConfig config = withCheckRail(Side::left);
  const RailSeries check{{0, checkRail(near_face, 0.04), {}}};
  config.rail_sections.left = std::make_shared<const RailSections>(
      std::vector<RailSeries>{config.rail_sections.left->parts()[0], check}, RailSections::Placement::coordinates);
  WheelsetContact contact(config);
  EXPECT_EQ(contact.evaluate(stateAt(0, wheel_load)).status, ContactStatus::ok);
  for (double y = -2e-3; y > -9e-3; y -= 0.5e-3)
  {
    EXPECT_FALSE(isUsable(contact.evaluate(stateAt(y, wheel_load)).status)) << y;
  }
}

/// Points of a profile between two lateral positions, as a spline.
static std::shared_ptr<const Profile> pieceOf(const Profile& profile, double begin, double end)
{
  std::vector<SampledPoint> points;
  for (double u = 0; u <= profile.length(); u += 2.5e-4)
  {
    const CurvePoint p = profile.at(u);
    if (p.y >= begin && p.y <= end)
    {
      points.push_back({p.y, p.z});
    }
  }
  return std::make_shared<const Profile>("piece", interpolatingSpline(points));
}

// The head of a rail as two parts, the gauge corner second. In the turned axes of the second search, the flange tip is
// below it by several millimetres.
TEST(CheckRail, IsNotSeenInTheGaugeCornerOfAnotherPart)
{
  ContactModelConfig whole = withCheckRail(Side::left);
  whole.rail_sections = nullptr;
  // The gauge is measured on the crown, because the first part has no gauge face.
  whole.track.gauge_depth = 2e-5;
  whole.track.gauge = 1.494;
  const Profile rail = rail60E1();
  ContactModelConfig divided = whole;
  divided.rail_sections.left = std::make_shared<const RailSections>(
      std::vector<RailSeries>{{{0, pieceOf(rail, -0.012, 0.04), {}}}, {{0, pieceOf(rail, -0.04, -0.012), {}}}},
      RailSections::Placement::coordinates);
  const PlacedRail placed = restingRail(divided, Side::left);
  RailSearch search(*divided.wheel_profile.left, placed.profile(), placed.profile().length(), true);
  search.setRail(placed);
  std::vector<OverlapInterval> intervals;
  WheelsetContact on_whole(whole), on_divided(divided);
  for (double y = 5e-3; y < 7e-3; y += 0.1e-3)
  {
    const WheelsetResult& one = okResult(on_whole, stateAt(y, wheel_load / 2));
    const WheelsetResult& other = okResult(on_divided, stateAt(y, wheel_load / 2));
    EXPECT_EQ(other.patches.size(), one.patches.size()) << y;
    // The points of the spline are off by up to 0.2 um at the ends of the arcs.
    EXPECT_NEAR(other.rail.left.lateral_force, one.rail.left.lateral_force, 0.03 * wheel_load) << y;
    search.setWheel({*divided.wheel_profile.left, divided.wheelset, Side::left, {y, other.z, 0, other.roll}});
    search.overlapIntervals(0, intervals);
    for (const OverlapInterval& interval : intervals)
    {
      EXPECT_FALSE(interval.seen) << y << ": slope " << interval.contact.slope;
    }
  }
}
}  // namespace wheel_rail_contact::core
