// SPDX-License-Identifier: BSD-3-Clause
#include "result_scene.h"
#include "ros/markers/contact_scene.h"
#include "ros/markers/marker_tools.h"
#include "ros/markers/track_markers.h"

using namespace wheel_rail_contact;
namespace
{
class Picture : public ResultScene
{
 protected:
  double max_pressure = 2e9;  ///< upper end of the colour scale of the pressure [Pa]
  double max_stress = 1e9;    ///< that of the von Mises stress [Pa]

  MarkerArray draw() const { return draw(config); }
  MarkerArray draw(const NodeConfig& node) const
  {
    return sceneMarkers(output, &node.model, ContactTrail(), sceneOptions(node.markers, max_pressure, max_stress));
  }
};

double width(const Marker& marker)
{
  const auto [right, left] = range(marker, &geometry_msgs::Point::y);
  return left - right;
}

void expectDrawable(const MarkerArray& markers)
{
  MarkerKeys keys;
  for (const Marker& marker : markers.markers)
  {
    SCOPED_TRACE(marker.ns + " " + std::to_string(marker.id));
    EXPECT_EQ(marker.header.frame_id, "track");
    EXPECT_TRUE(keys.emplace(marker.ns, marker.id).second) << "namespace and number are not unique";
    EXPECT_GT(marker.color.a, 0);
    const auto& q = marker.pose.orientation;
    EXPECT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1, 1e-12);
    EXPECT_TRUE(marker.colors.empty() || marker.colors.size() == marker.points.size());
    const std::size_t group = marker.type == Marker::TRIANGLE_LIST ? 3 : marker.type == Marker::LINE_LIST ? 2 : 1;
    EXPECT_EQ(marker.points.size() % group, 0U);
    for (const auto& p : marker.points)
    {
      EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    }
  }
}
}  // namespace

TEST_F(Picture, BothWheelProfilesLieOnTheirWheels)
{
  NodeConfig node = config;
  core::WheelsetConfig& wheelset = node.model.wheelset;
  wheelset.rolling_radius = {0.46, 0.45};
  const MarkerArray markers = draw(node);
  for (const int side : {0, 1})
  {
    const double rolling_radius = wheelset.rolling_radius[static_cast<core::Side>(side)];
    const Marker& line = findMarker(markers, "wheel_profile", side);
    double tread = 0, tip = 0;
    for (const auto& p : line.points)
    {
      EXPECT_EQ(p.y > 0, side == 0);
      const double radius = std::hypot(p.x - output.x(), p.z - output.pose().z);
      tip = std::max(tip, radius);
      if (std::abs(std::abs(p.y) - wheelset.halfBase()) < 2e-3)
      {
        tread = radius;
      }
    }
    EXPECT_NEAR(tread, rolling_radius, 2e-4) << "within 2 mm of the running circle, at a slope of about 1:40";
    EXPECT_NEAR(tip, rolling_radius + 0.028, 2e-4) << "the flange of S1002 is 28 mm high";
  }
}

TEST_F(Picture, MarkersAreValidAndTheLabelGivesPressureAndArea)
{
  expectDrawable(draw());
  expectDrawable(profileMarkers(config));
  EXPECT_EQ(findMarker(draw(), "label", 0).text, "982 MPa\n192 mm²");
}

TEST_F(Picture, TruePatchHasItsPositionAndSize)
{
  const Marker patch = findMarker(draw(), "patch", 16);
  EXPECT_NEAR(width(patch), 10e-3, 2.1e-3) << "width of 8 mm, plus up to one cell at each edge";
  for (const auto& p : patch.points)
  {
    EXPECT_NEAR(p.x, 3, 0.010);
    EXPECT_NEAR(p.y, -0.75, 0.006);
    EXPECT_NEAR(p.z, 0, 1e-3);
  }
}

TEST_F(Picture, MagnifiedPatchIsAboveItsRail)
{
  const MarkerArray markers = draw();
  const Marker& zoomed = findMarker(markers, "zoom", 0);
  // The patch is 8 mm wide. On each side the drawn edge is at most a quarter of a cell of 1 mm outside.
  EXPECT_NEAR(width(zoomed), config.markers.zoom * 8e-3, config.markers.zoom * 0.5e-3);
  // The grid is symmetric about the origin of the patch, which is 0.1 mm below the track plane.
  const double height = config.markers.pressure_height * result.patches[0].pressure.maxCoeff() / max_pressure;
  EXPECT_NEAR(range(zoomed, &geometry_msgs::Point::z).second, config.markers.zoom_height + height - 1e-4, 1e-9);
}

TEST_F(Picture, MagnifiedPatchesOfOneWheelDoNotOverlap)
{
  result.patches.push_back(makePatch(core::Side::right, 0.72));
  const MarkerArray markers = draw();
  const Marker &tread = findMarker(markers, "zoom", 16), &flange = findMarker(markers, "zoom", 17);
  EXPECT_GT(range(flange, &geometry_msgs::Point::y).first, range(tread, &geometry_msgs::Point::y).second);
}

TEST_F(Picture, ColourRepresentsThePressure)
{
  const Marker zoomed = findMarker(draw(), "zoom", 0);
  const auto top = std::max_element(zoomed.points.begin(), zoomed.points.end(),
                                    [](const auto& a, const auto& b) { return a.z < b.z; });
  const auto& color = zoomed.colors[static_cast<std::size_t>(top - zoomed.points.begin())];
  const auto expected = colorOf(result.patches[0].pressure.maxCoeff() / max_pressure);
  EXPECT_NEAR(color.r, expected.r, 1e-6);
  EXPECT_NEAR(color.g, expected.g, 1e-6);
  EXPECT_NEAR(color.b, expected.b, 1e-6);
}

TEST_F(Picture, PressureAboveTheScaleHasItsOwnColourAndANote)
{
  max_pressure = 5e8;
  const MarkerArray markers = draw();
  const Marker& zoomed = findMarker(markers, "zoom", 0);
  std::size_t above = 0;
  for (std::size_t i = 0; i < zoomed.points.size(); ++i)
  {
    const bool marked = zoomed.colors[i].r > 0.99F && zoomed.colors[i].b > 0.5F;  // no colour of viridis
    above += marked ? 1U : 0U;
    EXPECT_EQ(marked, zoomed.points[i].z > config.markers.zoom_height + config.markers.pressure_height - 1e-4 - 1e-9);
  }
  EXPECT_GT(above, zoomed.points.size() / 2) << "0.74 of the area of a Hertzian contact is above half its peak";
  EXPECT_LT(above, zoomed.points.size());
  EXPECT_EQ(findMarker(markers, "label", 0).text, "982 MPa, above scale\n192 mm²");
  EXPECT_EQ(findMarker(markers, "scale", 6).text, "above scale: 982 MPa");
  EXPECT_EQ(findMarker(markers, "scale", 5).text, "500 MPa");
  max_pressure = 1e9;
  EXPECT_THROW(findMarker(draw(), "scale", 6), std::out_of_range) << "nothing is above the scale";
}

TEST_F(Picture, SteepPatchIsMagnifiedFlatAboveTheRail)
{
  result.patches[0].pose.angle = 1.2;
  const MarkerArray markers = draw();
  const Marker& zoomed = findMarker(markers, "zoom", 0);
  EXPECT_NEAR(width(zoomed), config.markers.zoom * 8e-3, config.markers.zoom * 0.5e-3)
      << "seen from above in full width";
  for (const auto& p : zoomed.points)
  {
    EXPECT_GT(p.z, config.markers.zoom_height - 2e-4) << "nothing reaches down to the rail";
  }
}

TEST_F(Picture, ForceArrowPointsIntoTheRailAndHasTheLengthOfTheForce)
{
  const Marker arrow = findMarker(draw(), "force", 0);
  const auto &tail = arrow.points[0], &head = arrow.points[1];
  EXPECT_NEAR(std::hypot(head.y - tail.y, head.z - tail.z), config.markers.force_scale * 1e5, 1e-12);
  EXPECT_LT(head.z, tail.z);
  EXPECT_GT(head.y, tail.y) << "on the left rail the force on the tread points outward";
}

TEST_F(Picture, FrictionOnTheRailIsAnArrowInTheTangentPlane)
{
  EXPECT_THROW(findMarker(draw(), "friction", 0), std::out_of_range);
  result.patches[0].creep.force = {3e3, -4e3, 5};  // on the wheel
  const double angle = result.patches[0].pose.angle, scale = config.markers.force_scale;
  const MarkerArray markers = draw();
  const auto &tail = findMarker(markers, "friction", 0).points[0], &head = findMarker(markers, "friction", 0).points[1];
  const Eigen::Vector3d arrow(head.x - tail.x, head.y - tail.y, head.z - tail.z);
  EXPECT_LT((arrow - scale * Eigen::Vector3d(-3e3, 4e3 * std::cos(angle), 4e3 * std::sin(angle))).norm(), 1e-12);
  EXPECT_EQ(tail, findMarker(markers, "force", 0).points[0]);
}

TEST_F(Picture, RailIsDrawnDeflected)
{
  const MarkerArray before = draw();
  result.rail.left.deflection = {0.01, 0.002, 0};
  const MarkerArray after = draw();
  EXPECT_NEAR(findMarker(after, "rail", 0).points[0].y - findMarker(before, "rail", 0).points[0].y, 0.01, 1e-12);
  EXPECT_NEAR(findMarker(after, "rail", 0).points[0].z - findMarker(before, "rail", 0).points[0].z, 0.002, 1e-12);
  EXPECT_EQ(findMarker(after, "rail", 1).points[0].y, findMarker(before, "rail", 1).points[0].y);
}

TEST_F(Picture, VanishedPatchIsDeleted)
{
  MarkerArray first = draw();
  const MarkerKeys shown = appendDeletions({}, output.header, first);
  result.patches.pop_back();
  MarkerArray second = draw();
  const MarkerKeys now = appendDeletions(shown, output.header, second);
  for (const char* ns : {"patch", "zoom", "zoom_line", "force", "label"})
  {
    EXPECT_EQ(findMarker(second, ns, 16).action, Marker::DELETE) << ns;
    EXPECT_EQ(now.count({ns, 16}), 0U);
    EXPECT_EQ(now.count({ns, 0}), 1U);
  }
  MarkerArray third = draw();
  const std::size_t count = third.markers.size();
  appendDeletions(now, output.header, third);
  EXPECT_EQ(third.markers.size(), count) << "a marker is deleted only once";
}

TEST_F(Picture, UnusableResultShowsStatusAndReasonInRed)
{
  output.result = nullptr;
  output.status = WheelsetContact::INVALID_INPUT;
  output.reason = "pose: position is not finite";
  const MarkerArray markers = draw();
  const Marker& status = findMarker(markers, "status", 0);
  EXPECT_EQ(status.text, "INVALID_INPUT\n" + output.reason);
  EXPECT_GT(status.color.r, 2 * status.color.g);
  EXPECT_GT(status.color.r, 2 * status.color.b);
  expectDrawable(markers);
}

TEST_F(Picture, StatusIsShownForLiftOffAndWarningsOnly)
{
  output.status = WheelsetContact::OK;
  EXPECT_THROW(findMarker(draw(), "status", 0), std::out_of_range);
  output.reason = "a warning";
  EXPECT_EQ(findMarker(draw(), "status", 0).text, "OK\na warning");
  output.status = WheelsetContact::LIFT_OFF;
  output.reason = "the left wheel carries no load";
  EXPECT_EQ(findMarker(draw(), "status", 0).text, "LIFT_OFF\n" + output.reason);
}

TEST_F(Picture, PartsCanBeSwitchedOff)
{
  NodeConfig plain = config;
  plain.markers.zoom = 0;
  plain.markers.force_scale = 0;
  result.patches[0].creep.force = {3e3, -4e3, 5};
  for (const Marker& marker : draw(plain).markers)
  {
    EXPECT_TRUE(marker.ns != "zoom" && marker.ns != "zoom_line" && marker.ns != "force" && marker.ns != "friction")
        << marker.ns;
  }
}

TEST(ColorMap, BrightnessIncreasesWithTheValueAndIsClampedOutside)
{
  const auto brightness = [](double t)
  {
    const auto c = colorOf(t);
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;  // relative luminance of ITU-R BT.709
  };
  for (double t = 0; t < 1; t += 0.01)
  {
    EXPECT_LT(brightness(t), brightness(t + 0.01)) << t;
  }
  EXPECT_EQ(colorOf(-3).b, colorOf(0).b);
  EXPECT_EQ(colorOf(7).r, colorOf(1).r);
  EXPECT_EQ(colorOf(std::numeric_limits<double>::quiet_NaN()).g, colorOf(0).g);
}
