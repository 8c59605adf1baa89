// SPDX-License-Identifier: BSD-3-Clause
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

// Contact on rails whose surface rises, falls or bends along the track, and of wheels that are not round.
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

/// Polygon of the wheels, and its phase per length [rad/m].
constexpr int wave_order = 20;
constexpr double wave_height = 0.1e-3, wave_number = wave_order / 0.46;
const OutOfRound polygon{{}, {{wave_order, wave_height, 0}}, {}};

/// Result at a pitch of a scene in which both wheels are the same, under a load or at a height.
WheelsetResult turned(WheelsetState state, double pitch, const OutOfRound& wheel = polygon,
                      ContactModelConfig scene = fineScene())
{
  state.pitch = pitch;
  scene.wheelset.out_of_round = std::make_shared<const OutOfRound>(wheel);
  scene.wheelset.solve_height_and_roll = state.force_z != 0;
  WheelsetContact contact(scene);
  return okResult(contact, state);
}

/// Rise of the undeformed left wheel over that of another result [m].
double liftOf(const WheelsetResult& result, const WheelsetResult& other)
{
  return result.z - other.z + result.patches[0].approach - other.patches[0].approach;
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
  double lift() const { return liftOf(line, prism); }

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
  EXPECT_NEAR(up.lift(), step - before * before / (2 * radius()), 1e-6);
  EXPECT_NEAR(up.patch().pose.x, before, 0.2e-3);
  EXPECT_NE(up.line.reason.find("left rail has an edge"), std::string::npos) << up.line.reason;
  EXPECT_NEAR(up.line.rail.left.given.vertical, 0, 1e-12);
  const Pair dip(levelled([](double x) { return angle * std::abs(x); }), 0, stateAt(0, wheel_load));
  EXPECT_NEAR(dip.lift(), 0.5 * angle * angle * radius(), 0.1e-6);
  EXPECT_NEAR(std::abs(dip.patch().pose.x), angle * radius(), 0.05e-3);
  EXPECT_NE(dip.line.reason.find("edge"), std::string::npos) << dip.line.reason;
  // A smooth one has no warning.
  const Pair smooth(levelled([](double x) { return 0.3e-3 * std::sin(20 * x); }), 0.03, stateAt(0, wheel_load));
  EXPECT_EQ(smooth.line.reason, smooth.prism.reason);
}

TEST(WheelRimTest, PolygonFollowsItsSecondOrderUnderALoadAndAtAHeight)
{
  const WheelsetResult round = turned(stateAt(0, wheel_load), 0, {});
  for (const double phase : {0.0, 0.8, 2.0, 4.0})
  {
    const WheelsetResult result = turned(stateAt(0, wheel_load), phase / wave_order);
    const PatchResult &patch = result.patches[0], &before = round.patches[0];
    const double value = wave_height * std::sin(phase), slope = wave_height * wave_number * std::cos(phase),
                 x = patch.pose.x;
    const double curvature = 1 / radius() + wave_number * wave_number * value,
                 rise = value + slope * slope / (2 * curvature);
    // The slope over a contact is smaller by (5 mm * wave_number)² / 6 = 0.8 %.
    EXPECT_NEAR(liftOf(result, round), rise, 0.15e-6) << phase;
    EXPECT_NEAR(x, slope / curvature, 0.02e-3) << phase;
    EXPECT_NEAR(patch.wheel_angle, x / radius(), 1e-5) << phase;
    EXPECT_NEAR(patch.curvature_along - before.curvature_along, curvature - 1 / radius(), 0.003) << phase;
    EXPECT_NEAR(patch.rolling_radius - before.rolling_radius, wave_height * std::sin(phase + wave_number * x), 1e-6)
        << phase;
    // The rail is level: its force is vertical, and has a moment about the axle.
    EXPECT_NEAR(result.rail_wrench.force.x(), 0, 1e-9);
    EXPECT_NEAR(result.rail_wrench.moment.y(), -2 * x * wheel_load, 0.5) << phase;
    EXPECT_EQ(result.reason, round.reason);
    // At a height, it is a round wheel with its curvature, lower by the rise.
    ContactModelConfig other = fineScene();
    other.wheelset.rolling_radius = 1 / curvature;
    const double z = round.z - 20e-6, down = rise + radius() - 1 / curvature;
    const double force = turned(heldAt(0, z - down), 0, {}, other).wheel.left.vertical;
    EXPECT_NEAR(turned(heldAt(0, z), phase / wave_order).wheel.left.vertical, force, 0.01 * force);
  }
}

TEST(WheelRimTest, PolygonIsARailWithTheSameWave)
{
  const ContactModelConfig rails = sceneOn(levelled([](double x) { return wave_height * std::sin(wave_number * x); }));
  for (const double phase : {0.4, 1.2, 2.5, -2.0})
  {
    WheelsetState state = stateAt(0.003, wheel_load, 0.004);
    state.distance = phase / wave_number;
    const WheelsetResult line = turned(state, 0, {}, rails), wheel = turned(state, phase / wave_order);
    EXPECT_NEAR(wheel.z, line.z, 0.1e-6) << phase;
    EXPECT_NEAR(wheel.roll, line.roll, 1e-7) << phase;
    for (std::size_t k = 0; k < line.patches.size(); ++k)
    {
      EXPECT_LT(difference(wheel.patches.at(k), line.patches[k]), 0.003) << phase;
      EXPECT_NEAR(wheel.patches[k].pose.x, line.patches[k].pose.x, 0.03e-3) << phase;
    }
  }
}

TEST(WheelRimTest, EdgesOfAFlatCarryTheWheelInAndOutOfIt)
{
  constexpr double depth = 0.44e-3, middle = 3;
  const double half = std::acos(1 - depth / radius());  // its angle
  const WheelsetResult round = turned(stateAt(0, wheel_load), 0, {});
  for (const double ahead : {0.1, 0.03, 0.01, 0.0, -0.01, -0.03, -0.1})
  {
    const WheelsetResult result = turned(stateAt(0, wheel_load), middle - ahead, {{}, {}, {{middle, depth}}});
    const double edge = std::max(half - std::abs(ahead), 0.0), place = ahead > 0 ? -edge : ahead < 0 ? edge : 0;
    EXPECT_NEAR(liftOf(result, round), radius() * (std::cos(edge) - 1), 0.5e-6) << ahead;
    EXPECT_NEAR(result.patches[0].pose.x, radius() * place, 0.05e-3) << ahead;
    EXPECT_EQ(result.reason.find("left wheel has an edge") != std::string::npos, edge > 0) << result.reason;
  }
}

TEST(WheelRimTest, MeasuredRimIsPeriodicAndThatOfTheWavesInIt)
{
  const OutOfRound waves{{}, {{3, wave_height, 0}}, {}};
  OutOfRound measured;
  for (double angle = 0.3; angle < 0.3 + 2 * M_PI - 0.01; angle += M_PI / 180)
  {
    measured.table.push_back({angle, waves.at(angle, radius())});
  }
  for (double angle = -7; angle < 7; angle += 0.37)
  {
    EXPECT_NEAR(measured.at(angle + 8 * M_PI, radius()), waves.at(angle, radius()), 0.2e-6);
  }
  const WheelsetResult one = turned(stateAt(0, wheel_load), 0.4, measured);
  const WheelsetResult other = turned(stateAt(0, wheel_load), 0.4 - 6 * M_PI, waves);
  EXPECT_NEAR(one.z, other.z, 0.2e-6);
  EXPECT_NEAR(one.patches[0].pose.x, other.patches[0].pose.x, 0.1e-3);
}
