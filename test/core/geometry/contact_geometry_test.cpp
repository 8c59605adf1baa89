// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/contact_geometry.h"

#include "../../refusal.h"
#include "../balance/round_bodies.h"
#include "core/track/placement.h"

using namespace wheel_rail_contact::core;

namespace
{
constexpr double rail_radius = round_bodies::crown_radius;
constexpr double wheel_radius = 0.5;  ///< of the arc of the wheel profile [m]
constexpr double sine = 0.05;         ///< of the contact angle at y = 0 [-]

/// y of the centre of the rail arc, outward from the track centre [m].
double railCentre(const ContactModelConfig& config)
{
  return 0.5 * config.track.gauge + round_bodies::half_head;
}

/// Hollow wheels of one arc on rails of one arc: a contact angle with the given sine at y = 0.
ContactModelConfig arcs()
{
  ContactModelConfig config = round_bodies::scene(0);
  const double y = railCentre(config) + (wheel_radius - rail_radius) * sine - config.wheelset.halfBase();
  const double z = -std::sqrt(wheel_radius * wheel_radius - y * y);
  const double half = 0.12;  // angle of half the profile [rad]
  config.wheel_profile = std::make_shared<Profile>(
      "arc",
      std::vector<ProfileSection>{{ArcSection{y, z, wheel_radius, 0.5 * M_PI + half, -1}, 2 * half * wheel_radius}});
  return config;
}

ContactModelConfig standard(double inclination = 1.0 / 40)
{
  ContactModelConfig config;
  config.wheel_profile = std::make_shared<Profile>(s1002Wheel());
  config.rail_profile = std::make_shared<Profile>(rail60E1());
  config.track.rail_inclination = std::atan(inclination);
  return config;
}

ContactGeometryOptions range(double first, double last, double step, bool roll = true)
{
  ContactGeometryOptions options;
  options.y_first = first;
  options.y_last = last;
  options.y_step = step;
  options.roll = roll;
  return options;
}

/// Derivative of the rolling radius difference at y = 0, halved [-].
double conicityAtCentre(const ContactModelConfig& config)
{
  const ContactGeometry geometry = contactGeometry(config, range(-1e-5, 1e-5, 1e-5));
  return (geometry.points.back().radiusDifference() - geometry.points.front().radiusDifference()) / 4e-5;
}
}  // namespace

TEST(ContactGeometry, OfConesWithoutRollHasTheirConicity)
{
  const double slope = 0.05;
  ContactModelConfig config = round_bodies::scene(slope);
  config.wheelset.rolling_radius = {0.4604, 0.46};
  const ContactGeometry geometry = contactGeometry(config, range(-5e-3, 5e-3, 1e-3, false));
  ASSERT_EQ(geometry.points.size(), 11U);
  for (const GeometryPoint& point : geometry.points)
  {
    ASSERT_EQ(point.status, GeometryStatus::ok) << point.y;
    EXPECT_NEAR(point.radiusDifference(), 2 * slope * point.y + 4e-4, 1e-9) << point.y;
    EXPECT_NEAR(std::tan(point.touch.left.angle), slope, 1e-9);
    EXPECT_EQ(point.roll, 0);
  }
  ASSERT_FALSE(geometry.curve.empty());
  for (const RadiusDifference& point : geometry.curve)
  {
    EXPECT_NEAR(point.value, 2 * slope * point.y + 4e-4, 1e-9) << point.y;
  }
}

// Closed form: the line through the centres of both arcs is the normal. sin = sin0 + y / (R_wheel - R_rail) on the
// left.
TEST(ContactGeometry, OfArcsWithoutRollIsThatOfTheirCentres)
{
  const ContactModelConfig config = arcs();
  for (const GeometryPoint& point : contactGeometry(config, range(-8e-3, 8e-3, 1e-3, false)).points)
  {
    ASSERT_EQ(point.status, GeometryStatus::ok) << point.y;
    const double shift = point.y / (wheel_radius - rail_radius);
    const double left = std::asin(sine + shift), right = std::asin(sine - shift);
    EXPECT_NEAR(point.touch.left.angle, left, 1e-7) << point.y;
    EXPECT_NEAR(point.touch.right.angle, right, 1e-7) << point.y;
    EXPECT_NEAR(point.touch.left.y, railCentre(config) - rail_radius * std::sin(left), 1e-7) << point.y;
    EXPECT_NEAR(point.touch.right.y, -railCentre(config) + rail_radius * std::sin(right), 1e-7) << point.y;
    EXPECT_NEAR(point.touch.left.rail_y, -rail_radius * std::sin(left), 1e-7) << point.y;
    EXPECT_NEAR(point.radiusDifference(), wheel_radius * (std::cos(right) - std::cos(left)), 1e-8) << point.y;
  }
}

// Conicity of arcs with roll: Heumann (1937), also Wickens (2003), with the exact functions of the angle d in place of
// d: tan d R_w / (R_w - R_r) (b + R_r sin d) / (b - r tan d). Tolerance: the radii are accurate to 1e-9 m.
TEST(ContactGeometry, OfArcsWithRollHasTheConicityOfHeumann)
{
  const ContactModelConfig config = arcs();
  const double angle = std::asin(sine), tangent = std::tan(angle);
  const double base = railCentre(config) - rail_radius * sine;
  const double radius = contactGeometry(config, range(0, 1e-3, 1e-3)).points.front().touch.left.radius;
  const double exact =
      tangent * wheel_radius / (wheel_radius - rail_radius) * (base + rail_radius * sine) / (base - radius * tangent);
  EXPECT_NEAR(conicityAtCentre(config), exact, 1e-4 * exact);
}

// The same for cones, R_w infinite.
TEST(ContactGeometry, OfConesWithRollHasTheConicityOfHeumann)
{
  const double slope = 0.05, angle_sine = slope / std::hypot(1, slope);
  const ContactModelConfig config = round_bodies::scene(slope);
  const double base = railCentre(config) - rail_radius * angle_sine;
  const double radius = contactGeometry(config, range(0, 1e-3, 1e-3)).points.front().touch.left.radius;
  const double exact = slope * (base + rail_radius * angle_sine) / (base - radius * slope);
  EXPECT_NEAR(conicityAtCentre(config), exact, 1e-4 * exact);
}

// The point of the wheel at the touch, found from its position on the profile, is the point of the rail.
TEST(ContactGeometry, WheelsTouchTheRailsAtTheirPoints)
{
  ContactModelConfig config = standard();
  config.wheelset.rolling_radius = {0.459, 0.46};
  int flange_contacts = 0;
  for (const GeometryPoint& point : contactGeometry(config, range(-9e-3, 9e-3, 5e-4)).points)
  {
    ASSERT_EQ(point.status, GeometryStatus::ok) << point.y;
    for (const Side side : sides)
    {
      const TouchPoint& touch = point.touch[side];
      const Profile& profile = *config.wheel_profile[side];
      double low = 0, high = profile.length();
      while (high - low > 1e-12)
      {
        const double middle = 0.5 * (low + high);
        (profile.at(middle).y < touch.wheel_y ? low : high) = middle;
      }
      const PlacedWheel wheel(profile, config.wheelset, side, toSide(side, {point.y, point.z, 0, point.roll}));
      SpacePoint place{};
      ASSERT_TRUE(wheel.locus(profile.at(low), place));
      EXPECT_NEAR(sideSign(side) * place.y, touch.y, 1e-9) << point.y;
      EXPECT_NEAR(place.z, touch.z, 1e-9) << point.y;
      EXPECT_NEAR(touch.radius, config.wheelset.rolling_radius[side] - profile.at(low).z, 1e-9) << point.y;
      flange_contacts += touch.angle > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(flange_contacts, 4);
}

// Under 10 N on each wheel, the pose of the elastic contact is that of rigid bodies up to the approach: below 0.5 um
// along the normal, and thus below 1.5 um along z on a flange of 70°.
TEST(ContactGeometry, IsThatOfTheElasticContactWithoutLoad)
{
  const ContactModelConfig config = standard();
  WheelsetContact contact(config);
  for (const GeometryPoint& point : contactGeometry(config, range(-7e-3, 7e-3, 2e-3)).points)
  {
    WheelsetState state;
    state.y = point.y;
    state.force_z = -20;
    const WheelsetResult& result = contact.evaluate(state);
    ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
    EXPECT_NEAR(point.z, result.z, 1.5e-6) << point.y;
    EXPECT_NEAR(point.roll, result.roll, 2e-6) << point.y;
  }
}

TEST(ContactGeometry, OfTheMirrorImageIsMirrored)
{
  ContactModelConfig config = standard();
  config.wheelset.rolling_radius = {0.461, 0.46};
  config.track.rail_inclination = {0.05, 0.025};
  ContactModelConfig mirrored = config;
  mirrored.wheelset.rolling_radius = {0.46, 0.461};
  mirrored.track.rail_inclination = {0.025, 0.05};
  const ContactGeometry one = contactGeometry(config, range(-6e-3, 6e-3, 1e-3));
  const ContactGeometry other = contactGeometry(mirrored, range(-6e-3, 6e-3, 1e-3));
  ASSERT_EQ(one.points.size(), other.points.size());
  for (std::size_t i = 0; i < one.points.size(); ++i)
  {
    const GeometryPoint& point = one.points[i];
    const GeometryPoint& image = other.points[other.points.size() - 1 - i];
    EXPECT_EQ(point.y, -image.y);
    EXPECT_NEAR(point.radiusDifference(), -image.radiusDifference(), 1e-10) << point.y;
    EXPECT_NEAR(point.roll, -image.roll, 1e-11) << point.y;
    EXPECT_NEAR(point.touch.left.y, -image.touch.right.y, 1e-9) << point.y;
  }
}

TEST(ContactGeometry, CurveEnclosesAJumpOfTheContact)
{
  const auto curve = contactGeometry(standard(), range(-3e-3, 3e-3, 5e-4)).curve;
  int jumps = 0;
  for (std::size_t i = 1; i < curve.size(); ++i)
  {
    ASSERT_GT(curve[i].y, curve[i - 1].y);
    if (std::abs(curve[i].value - curve[i - 1].value) > 1e-4 && curve[i].y - curve[i - 1].y < 5e-5)
    {
      ++jumps;
      EXPECT_LE(curve[i].y - curve[i - 1].y, 1e-7);
    }
  }
  EXPECT_EQ(jumps, 2);  // one for each wheel
}

TEST(ContactGeometry, PositionsBeyondAProfileHaveAReason)
{
  const ContactGeometry geometry = contactGeometry(standard(), range(-0.1, 0.1, 2e-3));
  EXPECT_NE(geometry.points.front().status, GeometryStatus::ok);
  EXPECT_NE(geometry.points.back().status, GeometryStatus::ok);
  EXPECT_EQ(geometry.points[50].status, GeometryStatus::ok);
  EXPECT_EQ(geometry.points[50].y, 0);
  ASSERT_FALSE(geometry.curve.empty());
  for (const RadiusDifference& point : geometry.curve)
  {
    EXPECT_TRUE(std::isfinite(point.value)) << point.y;
    EXPECT_LT(std::abs(point.y), 0.08);
  }
}

// The left cone has missing points on the flange side of its touch at y = 0: the wheelset touches them for y > 0.
TEST(ContactGeometry, TouchesOnMissingPointsHaveAReasonAndEndTheCurve)
{
  const double slope = 0.05;
  ContactModelConfig config = round_bodies::scene(slope);
  const double touch = contactGeometry(config, range(0, 1e-3, 1e-3)).points.front().touch.left.wheel_y;
  const double cosine = 1 / std::hypot(1, slope), begin = config.wheel_profile.left->at(0).y, end = 0.06;
  ShapeError missing;
  missing.missing = true;
  config.wheel_profile.left = std::make_shared<Profile>(
      "gap", std::vector<ProfileSection>{
                 {LineSection{begin, begin * slope, cosine, cosine * slope}, (touch - begin) / cosine, missing},
                 {LineSection{touch, touch * slope, cosine, cosine * slope}, (end - touch) / cosine}});
  for (const bool roll : {false, true})
  {
    const ContactGeometry geometry = contactGeometry(config, range(-2.5e-3, 2.5e-3, 1e-3, roll));
    ASSERT_EQ(geometry.points.size(), 6U);
    for (const GeometryPoint& point : geometry.points)
    {
      EXPECT_EQ(point.status, point.y > 0 ? GeometryStatus::points_missing : GeometryStatus::ok) << point.y;
    }
    ASSERT_FALSE(geometry.curve.empty());
    EXPECT_LT(geometry.curve.back().y, 0);
  }
  EXPECT_STREQ(toString(GeometryStatus::points_missing), "points_missing");
}

TEST(ContactGeometry, RefusesOptionsOutOfRange)
{
  const auto refused = [](const ContactGeometryOptions& options, const std::string& name)
  { return refusalOf([&] { contactGeometry(standard(), options); }).rfind(name + " = ", 0) == 0; };
  EXPECT_TRUE(refused(range(-0.11, 0, 1e-3), "y_first"));
  EXPECT_TRUE(refused(range(0, 0.11, 1e-3), "y_last"));
  EXPECT_TRUE(refused(range(0.01, 0.01, 1e-3), "y_last"));
  EXPECT_TRUE(refused(range(0, 0.01, 0), "y_step"));
  EXPECT_TRUE(refused(range(-0.1, 0.1, 1e-6), "y_step"));
  EXPECT_TRUE(refused(range(0, std::nan(""), 1e-3), "y_last"));
}

TEST(ContactGeometry, NeedsOneRunningRailAtThePlace)
{
  ContactModelConfig config = standard();
  const auto rail = config.rail_profile.left;
  config.rail_sections.left = std::make_shared<RailSections>(std::vector<RailSeries>{{{0, rail, {}}, {1, rail, {}}}},
                                                             RailSections::Placement::gauge);
  ContactGeometryOptions options = range(-1e-3, 1e-3, 1e-3);
  EXPECT_EQ(contactGeometry(config, options).points.front().status, GeometryStatus::ok);
  options.distance = 1.5;
  EXPECT_THROW(contactGeometry(config, options), std::invalid_argument);
  config.rail_sections.left = std::make_shared<RailSections>(
      std::vector<RailSeries>{{{0, rail, {}}}, {{0, rail, {}}, {1, rail, {}}}}, RailSections::Placement::coordinates);
  options.distance = 0.5;
  EXPECT_THROW(contactGeometry(config, options), std::invalid_argument);
}
