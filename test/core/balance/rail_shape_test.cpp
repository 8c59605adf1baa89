// SPDX-License-Identifier: BSD-3-Clause
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

// Contact on rails whose surface rises, falls or bends along the track.
namespace
{
/// Radius of both wheels [m].
double radius()
{
  return manchesterScene().wheelset.meanRadius();
}

/// Shape of both rails: height and outward position of their heads at x [m].
struct Course
{
  std::function<double(double)> level = [](double) { return 0.0; };
  std::function<double(double)> lateral = [](double) { return 0.0; };
};

ContactModelConfig sceneOn(const Course& course)
{
  std::vector<LineStation> stations;
  for (int i = -150; i <= 150; ++i)
  {
    const double x = 2e-3 * i, level = course.level(x), lateral = course.lateral(x);
    stations.push_back({x, 0, {RailDeflection{lateral, level, 0}, RailDeflection{-lateral, level, 0}}});
  }
  ContactModelConfig scene = fineScene();
  scene.track.line = std::make_shared<TrackLine>("line", stations);
  return scene;
}

/// Results of the same state on the line and on prisms that lie as its rails do at the place.
struct Pair
{
  Pair(const Course& course, double x, WheelsetState state, ContactModelConfig straight = fineScene())
  {
    const ContactModelConfig scene = sceneOn(course);
    WheelsetContact on_line(scene), on_prism(straight);
    state.distance = x;
    line = okResult(on_line, state);
    state.rail_displacement = scene.track.line->at(x).rail;
    prism = okResult(on_prism, state);
  }

  const PatchResult& patch() const { return line.patches[0]; }
  /// Rise of the undeformed wheel on the line over that on the prism [m].
  double lift() const { return line.z - prism.z + patch().approach - prism.patches[0].approach; }

  WheelsetResult line, prism;
};

/// Course with the level f(x).
template <typename Level>
Course levelled(const Level& level)
{
  Course course;
  course.level = level;
  return course;
}
}  // namespace

TEST(RailShapeTest, RampLiftsTheAxleAndTurnsTheNormal)
{
  constexpr double slope = 0.007;
  for (const double yaw : {0.0, 0.01})
  {
    const Pair pair(levelled([](double x) { return slope * x; }), 0.02, stateAt(0, wheel_load, yaw));
    EXPECT_NEAR(pair.lift(), radius() * (std::sqrt(1 + slope * slope) - 1), 0.05e-6);
    EXPECT_NEAR(pair.patch().pose.x - pair.prism.patches[0].pose.x, slope * radius(), 0.02e-3);
    EXPECT_NEAR(pair.patch().wheel_angle - pair.prism.patches[0].wheel_angle, slope, 4e-5);
    EXPECT_NEAR(pair.patch().slope_along, slope, 2e-5);
    EXPECT_NEAR(std::tan(pair.patch().pose.pitch), -slope, 2e-5);
    EXPECT_NEAR(pair.patch().max_pressure, pair.prism.patches[0].max_pressure, 2e-3 * pair.patch().max_pressure);
    EXPECT_NEAR(pair.line.rail_wrench.force.x(), -2 * slope * wheel_load, 2e-3 * slope * wheel_load);
    // The normal force of a round wheel has no moment about its axle.
    EXPECT_NEAR(pair.line.rail_wrench.moment.dot(axleDirection(yaw, pair.line.roll)), 0, 2e-3 * slope * wheel_load);
    EXPECT_NEAR(pair.line.rail.left.slope.vertical, slope, 1e-12);
  }
}

TEST(RailShapeTest, SineOfOneMetreAndOfThreeTenthsFollowsItsSecondOrder)
{
  for (const double length : {0.3, 1.0})
  {
    const double k = 2 * M_PI / length, amplitude = 0.0063 / k;
    const Course course = levelled([&](double x) { return amplitude * std::sin(k * x); });
    for (const double phase : {0.0, 0.8, 1.4})
    {
      SCOPED_TRACE(std::to_string(length) + " m, phase " + std::to_string(phase));
      const Pair pair(course, phase / k, stateAt(0, wheel_load));
      const double slope = amplitude * k * std::cos(phase), bend = -amplitude * k * k * std::sin(phase);
      const double curvature = 1 / radius() - bend;
      EXPECT_NEAR(pair.lift(), slope * slope / (2 * curvature), 0.08e-6);
      EXPECT_NEAR(pair.patch().pose.x, slope / curvature, 0.02e-3);
      EXPECT_NEAR(pair.patch().curvature_along - pair.prism.patches[0].curvature_along, -bend, 2e-3);
    }
  }
}

TEST(RailShapeTest, DipIsThatOfALargerWheel)
{
  constexpr double bend = 0.5;  // [1/m]
  ContactModelConfig larger = fineScene();
  larger.wheelset.rolling_radius = 1 / (1 / radius() - bend);
  const Pair pair(levelled([](double x) { return 0.5 * bend * x * x; }), 0, stateAt(0, wheel_load), larger);
  EXPECT_LT(difference(pair.patch(), pair.prism.patches[0]), 0.005);
  EXPECT_NEAR(pair.patch().curvature_along, pair.prism.patches[0].curvature_along, 2e-3);
}

TEST(RailShapeTest, ForceAtAGivenHeightIsThatOfThePrismLowerByTheLift)
{
  constexpr double slope = 0.008, lift = 0.5 * slope * slope;
  const auto given = [](ContactModelConfig scene)
  {
    scene.wheelset.solve_height_and_roll = false;
    return scene;
  };
  WheelsetContact on_ramp(given(sceneOn(levelled([](double x) { return slope * x; })))), on_prism(given(fineScene()));
  WheelsetContact under_load(fineScene());
  const double height = okResult(under_load, stateAt(0, wheel_load)).z;
  for (const double higher : {-60e-6, 0.0, 50e-6})
  {
    const double z = height + higher, down = lift * radius();
    EXPECT_NEAR(okResult(on_ramp, heldAt(0, z)).wheel.left.vertical,
                okResult(on_prism, heldAt(0, z - down)).wheel.left.vertical, 0.005 * wheel_load);
  }
}

TEST(RailShapeTest, RailsThatRunAsideAreThoseThatTurn)
{
  constexpr double angle = 0.006, outward = 0.008;
  Course course;
  course.lateral = [](double x) { return std::tan(angle) * x; };
  WheelsetContact aside(sceneOn(course)), straight(fineScene());
  // Turned about the axle, the rails are as far apart, but wider by 1 / cos in a section.
  const double wider = 0.7175 * (1 / std::cos(angle) - 1);
  WheelsetState state = stateAt(outward, wheel_load);
  state.rail_displacement = RailDeflection{wider, 0, 0};
  const PatchResult found = okResult(aside, state).patches[0];
  const PatchResult& turned = okResult(straight, stateAt(outward, wheel_load, -angle)).patches[0];
  EXPECT_LT(difference(found, turned), 0.005);
  EXPECT_NEAR(found.wheel_angle, turned.wheel_angle, 2e-4);
  EXPECT_NEAR(found.pose.x - turned.pose.x, -angle * turned.pose.y, 0.1e-3);
  EXPECT_NEAR(found.slope_along, -std::sin(found.contact_angle) * angle, 2e-4);
}

TEST(RailShapeTest, EdgesThatTheSecondOrderDoesNotShowCarryTheWheel)
{
  constexpr double step = 0.1e-3, before = 6e-3, angle = 6e-3;
  const Pair up(levelled([](double x) { return x > 1e-3 ? step : 0; }), 2e-3 - before, stateAt(0, wheel_load));
  EXPECT_NEAR(up.lift(), step - before * before / (2 * radius()), 3e-6);
  EXPECT_NEAR(up.patch().pose.x, before, 1.1e-3);
  EXPECT_NE(up.line.reason.find("left rail has an edge"), std::string::npos) << up.line.reason;
  EXPECT_NEAR(up.line.rail.left.given.vertical, 0, 1e-12);
  const Pair dip(levelled([](double x) { return angle * std::abs(x); }), 0, stateAt(0, wheel_load));
  EXPECT_NEAR(dip.lift(), 0.5 * angle * angle * radius(), 2e-6);
  EXPECT_NEAR(std::abs(dip.patch().pose.x), angle * radius(), 1.1e-3);
  EXPECT_NE(dip.line.reason.find("edge"), std::string::npos) << dip.line.reason;
  // A smooth one has no warning.
  const Pair smooth(levelled([](double x) { return 0.3e-3 * std::sin(20 * x); }), 0.03, stateAt(0, wheel_load));
  EXPECT_EQ(smooth.line.reason, smooth.prism.reason);
}
