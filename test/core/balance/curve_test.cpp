// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/track_frame.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

// A track frame that turns along a line with curvature, cant and gradient.
namespace
{
constexpr double curve_radius = 300, curve_speed = 20;  // [m], [m/s]

ContactModelConfig sceneWith(const std::vector<LineStation>& stations)
{
  ContactModelConfig scene = fineScene(0.002);
  scene.creep.method = CreepMethod::fastsim;
  scene.track.line = std::make_shared<TrackLine>("curve", stations);
  return scene;
}

/// Stations with a design that changes evenly from the first to the last one.
std::vector<LineStation> designed(const TrackDesign& first, const TrackDesign& last)
{
  return {{-1, 0, {}, first}, {1, 0, {}, last}};
}
}  // namespace

// The same as rails of a straight track that turn and bend to the left, up and about x.
TEST(CurveTest, DesignIsWhatTheTrackFrameSeesOfIt)
{
  constexpr double curvature = 1 / curve_radius, change = 2e-4, twist = 1.7e-3;  // vertical radius 5000 m, cant 1:400
  WheelsetContact curve(sceneWith(designed({curvature, -twist, -change}, {curvature, twist, change})));
  std::vector<LineStation> stations;
  for (int i = -40; i <= 40; ++i)
  {
    const double x = 5e-3 * i, left = 0.5 * curvature * x * x, up = 0.5 * change * x * x;
    stations.push_back({x, 1.507 * twist * x, {RailDeflection{left, up, 0}, {-left, up, 0}}});
  }
  WheelsetContact line(sceneWith(stations));
  for (const double yaw : {0.0, -4e-3})
  {
    const WheelsetState state = stateAt(-5e-3, wheel_load, yaw);
    const WheelsetResult &found = okResult(curve, state), &expected = okResult(line, state);
    ASSERT_EQ(found.patches.size(), expected.patches.size());
    EXPECT_NEAR(found.rail.left.slope.vertical, twist * 0.75, 0.01 * twist);
    for (std::size_t i = 0; i < found.patches.size(); ++i)
    {
      EXPECT_LT(difference(found.patches[i], expected.patches[i]), 2e-4);
      EXPECT_NEAR(found.patches[i].pose.x, expected.patches[i].pose.x, 5e-6);
      EXPECT_NEAR(found.patches[i].slope_along, expected.patches[i].slope_along, 2e-5);
    }
  }
}

TEST(CurveTest, FrameFollowsCircleClothoidAndGradient)
{
  const TrackDesign arc{1 / curve_radius, -0.06, 0.02};
  const TrackPath path(std::make_shared<TrackLine>(
      "path", std::vector<LineStation>{{10, 0, {}}, {100, 0, {}}, {160, 0, {}, arc}, {700, 0, {}, arc}}));
  EXPECT_TRUE(path.frameAt(50).isApprox(Eigen::Isometry3d(Eigen::Translation3d(50, 0, 0)), 1e-15));
  const Eigen::Isometry3d begin = path.frameAt(160), end = path.frameAt(700);
  constexpr double turn = 0.1;  // of the clothoid, L / (2 R); its offset is L² / (6 R) (1 - turn² / 14)
  EXPECT_NEAR(begin.translation().y(), 2.0 * (1 - turn * turn / 14), 1e-5);
  EXPECT_NEAR(std::atan2(begin(1, 0), begin(0, 0)), turn, 1e-12);
  const Eigen::Vector3d chord = end.translation() - begin.translation();
  EXPECT_NEAR(chord.head<2>().norm(), 2 * curve_radius * std::sin(0.5 * 540 / curve_radius), 1e-6);
  EXPECT_NEAR(end(2, 0), std::sin(std::atan(0.02)), 1e-12);  // x uphill
  EXPECT_NEAR(path.placeOf(path.frameAt(130) * Eigen::Vector3d(0, 5e-3, 0.46)), 130, 1e-8);
}

// The motion over ground is that of the axle in the fixed frame, by differences of its poses.
TEST(CurveTest, MotionInTheFixedFrameGivesTheResultOfTheLocalOne)
{
  constexpr double way = 1e-3;
  const ContactModelConfig config = sceneWith(designed({2e-3, -0.06, 0.01}, {4e-3, -0.05, 0.014}));
  const TrackPath path(config.track.line);
  WheelsetContact contact(config);
  WheelsetState state = stateAt(-5e-3, wheel_load, 2e-3);
  state.motion.speed = curve_speed;
  const WheelsetResult local = okResult(contact, state);
  const auto axle = [&](double x) { return path.frameAt(x) * Eigen::Translation3d(0, state.y, local.z); };
  const Eigen::Isometry3d to_frame = axle(0).inverse(), before = to_frame * axle(-way), after = to_frame * axle(way);
  const double rate = curve_speed / (path.frameAt(way).translation() - path.frameAt(-way).translation()).norm();
  const Eigen::Vector3d velocity = rate * (after.translation() - before.translation());
  const Eigen::AngleAxisd turned(before.linear().transpose() * after.linear());
  const Eigen::Vector3d rotation = rate * turned.angle() * turned.axis();
  state.motion_over_ground = true;
  state.motion.speed = velocity.x();
  state.motion.lateral_velocity = velocity.y();
  state.motion.yaw_rate = rotation.z();
  const WheelsetResult& fixed = okResult(contact, state);
  EXPECT_NEAR(fixed.rotation - rotation.y(), local.rotation, 2e-8 * local.rotation);
  for (std::size_t i = 0; i < local.patches.size(); ++i)
  {
    const Creepage &one = local.patches[i].creep.creepage, &other = fixed.patches[i].creep.creepage;
    EXPECT_NEAR(one.x, other.x, 2e-8);
    EXPECT_NEAR(one.y, other.y, 2e-8);
    EXPECT_NEAR(one.spin, other.spin, 1e-6);
  }
}

// The worked example of doc/curves.md, with its figures.
TEST(CurveTest, ForcesOfTheRailsBalanceWeightAndCentripetalForce)
{
  constexpr double gravity = 9.81, mass = 2 * wheel_load / gravity, height = 1.2, curvature = 1 / curve_radius;
  const double cant = std::asin(0.1 / 1.5), across = curve_speed * curve_speed / curve_radius;  // [m/s²]
  ContactModelConfig scene = sceneWith(designed({curvature, -cant, 0}, {curvature, -cant, 0}));
  scene.wheelset.balance = WheelsetConfig::Balance::moments;
  WheelsetContact contact(scene);
  const double outward = mass * (across * std::cos(cant) - gravity * std::sin(cant));
  WheelsetState state;
  state.force_z = -mass * (gravity * std::cos(cant) + across * std::sin(cant));
  state.torque_x = height * outward;
  state.motion.speed = curve_speed;
  // Lateral position and yaw at which no lateral force and no moment about z is left on the axle.
  Eigen::Vector2d place(-5e-3, 0);
  const auto rest = [&](const Eigen::Vector2d& at)
  {
    state.y = at.x();
    state.yaw = at.y();
    const Wrench& wrench = okResult(contact, state).rail_wrench;
    return Eigen::Vector2d(wrench.force.y() - outward, wrench.moment.z());
  };
  for (int i = 0; i < 4; ++i)
  {
    const Eigen::Vector2d now = rest(place), by_y = rest(place + Eigen::Vector2d(1e-5, 0)) - now,
                          by_yaw = rest(place + Eigen::Vector2d(0, 1e-5)) - now;
    place -= 1e-5 * (Eigen::Matrix2d() << by_y, by_yaw).finished().inverse() * now;
  }
  rest(place);
  const WheelsetResult& result = okResult(contact, state);
  const TrackPath path(contact.config().track.line);
  const Eigen::Vector3d in_fixed = path.frameAt(-1).linear() * result.rail_wrench.force;
  EXPECT_NEAR(in_fixed.y(), mass * across, 3e-4 * mass * across);  // steps of 4 N by the tolerance of 0.2 %
  EXPECT_NEAR(in_fixed.z(), mass * gravity, 1e-4 * mass * gravity);
  EXPECT_NEAR(result.rail_wrench.moment.x(), -height * outward, 1e-3 * height * outward);
  EXPECT_NEAR(1e3 * place.x(), -4.94, 0.01);
  EXPECT_NEAR(1e3 * place.y(), 0.240, 0.002);
  EXPECT_NEAR(1e-3 * result.wheel.left.vertical, 82.9, 0.1);
  EXPECT_NEAR(1e-3 * result.wheel.right.vertical, 118.4, 0.1);
  EXPECT_NEAR(1e-3 * result.wheel.left.lateral, -2.5, 0.1);
  EXPECT_NEAR(1e-3 * result.wheel.right.lateral, 11.3, 0.1);
}
