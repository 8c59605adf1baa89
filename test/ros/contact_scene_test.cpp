// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/contact_scene.h"
#include "core/balance/rail_support.h"
#include "result_scene.h"
#include "ros/evaluation/conversions.h"
#include "ros/markers/contact_view.h"
#include "ros/markers/rail_motion.h"

using namespace wheel_rail_contact;
namespace
{
class Scene : public ResultScene
{
 protected:
  MarkerArray draw() const { return sceneMarkers(output, &config.model, trail, options); }

  ContactTrail trail;
  SceneOptions options;
};

std::size_t count(const MarkerArray& markers, const std::string& ns)
{
  return static_cast<std::size_t>(std::count_if(markers.markers.begin(), markers.markers.end(),
                                                [&](const Marker& marker) { return marker.ns == ns; }));
}

TEST_F(Scene, PressureInTrueSizeIsDrawnOnItsPatch)
{
  options.patch.zoom = 1;
  options.patch.lift = 0;
  options.patch.pressure_height = 0.02;
  const core::PatchResult& patch = result.patches[1];
  const MarkerArray markers = draw();
  const Eigen::AngleAxisd turn(patch.pose.angle, Eigen::Vector3d::UnitX());
  Eigen::Vector3d largest = Eigen::Vector3d::Zero();
  for (const auto& p : findMarker(markers, "zoom", 16).points)
  {
    const Eigen::Vector3d from_origin(p.x - output.x(), p.y - patch.pose.y, p.z - patch.pose.z);
    largest = largest.cwiseMax((turn.inverse() * from_origin).cwiseAbs());
  }
  // The edge is located between the cells of 1 mm, with an error of at most a fifth of a cell.
  EXPECT_NEAR(largest.x(), 8e-3, 2e-4);
  EXPECT_NEAR(largest.y(), 4e-3, 2e-4);
  // The centre of the ellipse is between four cell centres, at which the pressure is 1.0 % lower.
  EXPECT_NEAR(largest.z(), 0.02 * 982e6 / options.patch.max_pressure, 2e-4);
  EXPECT_EQ(count(markers, "patch"), 0U) << "a second picture in the same position";
}

TEST_F(Scene, PointsOfTheProfileMoveWithTheRail)
{
  const core::PlacedRail at_rest = core::restingRail(config.model, core::Side::left);
  const core::RailDeflection from{1e-3, -2e-4, 0.01}, to{8e-3, 3e-3, -0.05};
  const core::PlacedRail before = at_rest.deflected(from), after = at_rest.deflected(to);
  for (const core::Side side : {core::Side::left, core::Side::right})
  {
    const double sign = core::sideSign(side);
    for (const double u : {0.02, 0.05, 0.07})
    {
      const core::PlanePoint a = before.at(u), b = after.at(u);
      const core::PatchPose moved =
          carriedByRail(at_rest, side, from, to, {0.3, sign * a.y, a.z, sign * std::atan2(a.dz, a.dy)});
      EXPECT_DOUBLE_EQ(moved.x, 0.3);
      EXPECT_NEAR(moved.y, sign * b.y, 1e-12);
      EXPECT_NEAR(moved.z, b.z, 1e-12);
      EXPECT_NEAR(std::remainder(moved.angle - sign * std::atan2(b.dz, b.dy), 2 * M_PI), 0, 1e-12);
    }
  }
}

TEST_F(Scene, PatchMovesWithTheMagnifiedDeflection)
{
  result.rail.left.deflection.lateral = 1e-3;
  options.deflection_scale = 11;
  const auto before = findMarker(sceneMarkers(output, &config.model, trail, SceneOptions()), "force", 0).points[0];
  const auto after = findMarker(draw(), "force", 0).points[0];
  EXPECT_NEAR(after.y - before.y, 10e-3, 1e-12) << "outward is to the left on the left rail";
  EXPECT_NEAR(after.z, before.z, 1e-12);
}

TEST_F(Scene, GivenDisplacementIsDrawnInItsTrueSize)
{
  options.deflection_scale = 11;
  const auto sections = [](const MarkerArray& markers) { return findMarker(markers, "rail", 0).points; };
  const auto at_rest = sections(draw());
  const auto force_at_rest = findMarker(draw(), "force", 0).points[0];
  result.rail.left.given = result.rail.left.deflection = {2e-3, -3e-3, 0};
  result.rail.left.deflection.lateral += 1e-3;
  const auto moved = sections(draw());
  ASSERT_EQ(moved.size(), at_rest.size());
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    EXPECT_NEAR(moved[i].y - at_rest[i].y, 2e-3 + 11e-3, 1e-12);
    EXPECT_NEAR(moved[i].z - at_rest[i].z, -3e-3, 1e-12);
  }
  // The patch is on the displaced rail already: only the additional ten millimetres move it.
  const auto force = findMarker(draw(), "force", 0).points[0];
  EXPECT_NEAR(force.y - force_at_rest.y, 10e-3, 1e-12);
  EXPECT_NEAR(force.z - force_at_rest.z, 0, 1e-12);

  result.rail.left.deflection = result.rail.left.given = {1e-3, 2e-3, 0.01};
  const auto only_given = sections(draw());
  options.deflection_scale = 1;
  const auto true_size = sections(draw());
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    EXPECT_NEAR(only_given[i].y, true_size[i].y, 1e-12);
    EXPECT_NEAR(only_given[i].z, true_size[i].z, 1e-12);
  }
}

TEST_F(Scene, OnlyTheSelectedSideIsDrawn)
{
  options.track.sides = {core::Side::right};
  trail.add(output, {});
  const MarkerArray markers = draw();
  for (const char* ns : {"rail", "rail_at_rest", "wheel", "zoom", "outline", "force", "label"})
  {
    EXPECT_EQ(count(markers, ns), 1U) << ns;
  }
  EXPECT_EQ(findMarker(markers, "trail", 1).points.size(), 1U);
  EXPECT_LT(findMarker(markers, "trail", 1).points[0].y, 0);
}

TEST_F(Scene, OutlineHasTheLengthOfTheEllipse)
{
  options.patch.zoom = 1;
  options.patch.lift = 0;
  const Marker outline = findMarker(draw(), "outline", 0);
  double length = 0;
  for (std::size_t i = 0; i + 1 < outline.points.size(); i += 2)
  {
    const auto &a = outline.points[i], &b = outline.points[i + 1];
    length += std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
  }
  // Circumference of an ellipse with semi-axes of 8 mm and 4 mm: 38.75 mm (Ramanujan 1914). The edge is interpolated
  // between cells of 1 mm.
  EXPECT_NEAR(length, 38.75e-3, 1e-3);
}

TEST_F(Scene, WithoutModelAndGridsOnlyForcesAndLabelsAreDrawn)
{
  for (core::PatchResult& patch : result.patches)
  {
    patch.grid = core::PatchGrid();
    patch.grid.nx = patch.grid.ny = 0;
    patch.pressure.resize(0, 0);
  }
  const MarkerArray markers = sceneMarkers(output, nullptr, trail, options);
  EXPECT_EQ(count(markers, "force"), 2U);
  EXPECT_EQ(count(markers, "label"), 2U);
  EXPECT_EQ(markers.markers.size(), 4U);
}

TEST_F(Scene, UnusableResultKeepsRailsTrailAndWheelsetButNoPatches)
{
  trail.add(output, {});
  const auto usable = findMarker(draw(), "wheel_profile", 0).points[0];
  output.result = nullptr;
  output.status = WheelsetContact::OFF_PROFILE;
  output.state.y = 0.06;
  output.state.z = 0.47;
  const MarkerArray markers = draw();
  for (const char* ns : {"rail", "rail_at_rest", "wheel", "wheel_profile"})
  {
    EXPECT_EQ(count(markers, ns), 2U) << ns;
  }
  EXPECT_EQ(count(markers, "trail"), 1U);
  for (const char* ns : {"patch", "zoom", "zoom_line", "outline", "force", "label"})
  {
    EXPECT_EQ(count(markers, ns), 0U) << ns;
  }
  const auto refused = findMarker(markers, "wheel_profile", 0).points[0];
  EXPECT_NEAR(refused.y - usable.y, 0.06, 1e-12) << "the wheelset is at the pose of the output";
  EXPECT_NEAR(refused.z - usable.z, 0.01, 1e-12);
}

TEST_F(Scene, OutputWithoutPoseShowsOnlyTheRails)
{
  output.result = nullptr;
  output.status = WheelsetContact::INVALID_INPUT;
  output.state = core::WheelsetState();
  const MarkerArray markers = draw();
  EXPECT_EQ(count(markers, "rail"), 2U);
  EXPECT_EQ(markers.markers.size(), count(markers, "rail") + count(markers, "rail_at_rest"));
}

TEST_F(Scene, CutWheelEndsWithItsSectionAtTheContact)
{
  options.track.wheel_cut = true;
  const MarkerArray markers = draw();
  EXPECT_EQ(count(markers, "wheel_lines"), 0U);
  double last = output.x();
  for (const auto& p : findMarker(markers, "wheel", 0).points)
  {
    EXPECT_GE(p.x, output.x() - 1e-12) << "nothing is drawn behind the contact";
    last = std::max(last, p.x);
  }
  EXPECT_GT(last, output.x() + 0.1);
  for (const auto& p : findMarker(markers, "wheel_profile", 0).points)
  {
    EXPECT_NEAR(p.x, output.x(), 1e-12);
  }
}

TEST_F(Scene, TrailIsStoredOnTheRailAtRest)
{
  const auto at_rest = restingRails(&config.model, 0);
  trail.add(output, at_rest);
  result.rail.right.deflection.lateral = 2e-3;
  result.patches[1].pose.y -= 2e-3;  // the rail has moved outward, and the patch with it
  output.header.stamp += ros::Duration(1);
  trail.add(output, at_rest);
  ASSERT_EQ(trail.points().size(), 4U);
  EXPECT_NEAR(trail.points()[3].pose.y, trail.points()[1].pose.y, 1e-12);

  trail.limit(3);
  EXPECT_EQ(trail.points().size(), 3U);
  output.header.stamp -= ros::Duration(2);
  trail.add(output, at_rest);
  EXPECT_EQ(trail.points().size(), 2U) << "time has gone back";
}

TEST_F(Scene, WheelsetCanBeDrawnAtTheOrigin)
{
  trail.add(output, {});
  output.state.x += 1;
  output.header.stamp += ros::Duration(1);
  options.drawn_x = 0;
  const MarkerArray markers = draw();
  EXPECT_NEAR(findMarker(markers, "force", 0).points[0].x, 0, 1e-12);
  EXPECT_NEAR(findMarker(markers, "trail", 0).points[0].x, -1, 1e-12);
  trail.add(output, {});
  const Marker ways = findMarker(draw(), "trail ways", 0);
  EXPECT_NEAR(ways.points.at(4).x - ways.points.at(5).x, 1, 1e-12) << "from the result before";
}

TEST_F(Scene, OutputIsRestoredFromItsMessage)
{
  output.status = WheelsetContact::OK;
  for (core::PatchResult& patch : result.patches)
  {
    patch.method = "hertz";
  }
  result.y = 2e-3;
  const ContactOutput back = outputFromMessage(toMessage(output, true));
  EXPECT_EQ(back.header.stamp, output.header.stamp);
  EXPECT_DOUBLE_EQ(back.x(), output.x());
  EXPECT_DOUBLE_EQ(back.pose().y, 2e-3);
  ASSERT_NE(back.result, nullptr);
  EXPECT_EQ(back.result->patches.size(), 2U);

  output.result = nullptr;
  output.status = WheelsetContact::NO_TRANSFORM;
  EXPECT_EQ(outputFromMessage(toMessage(output, true)).result, nullptr);
}

TEST_F(Scene, MessageOfARejectedInputHasNoPoseAndIsDrawnWithoutAWheelset)
{
  output.result = nullptr;
  output.status = WheelsetContact::NO_TRANSFORM;
  output.state = core::WheelsetState();
  output.rejected = true;
  const WheelsetContact message = toMessage(output, true);
  EXPECT_FALSE(hasPose(message.wheelset));
  output = outputFromMessage(message);
  EXPECT_FALSE(hasPose(output));
  EXPECT_EQ(count(draw(), "wheel_profile"), 0U);
}

constexpr double spacing = 0.15;

class FollowedContact : public ResultScene
{
 protected:
  FollowedContact() { result.patches[0].pose.angle = 1.15; }  // 66°, a flange contact

  MarkerArray draw() { return view.markers(output, &config.model, trail, options, spacing); }
  static Eigen::Vector3d inPicture(const Marker& marker, const geometry_msgs::Point& p)
  {
    const geometry_msgs::Point& o = marker.pose.position;
    const geometry_msgs::Quaternion& q = marker.pose.orientation;
    return Eigen::Vector3d(o.x, o.y, o.z) + Eigen::Quaterniond(q.w, q.x, q.y, q.z) * Eigen::Vector3d(p.x, p.y, p.z);
  }
  Eigen::Vector3d firstRailPoint(int side)
  {
    const MarkerArray markers = draw();
    const Marker& rail = findMarker(markers, "rail", side);
    return inPicture(rail, rail.points.at(0));
  }

  ContactView view;
  ContactTrail trail;
  SceneOptions options;
};

TEST_F(FollowedContact, IsAtTheOriginWithItsNormalUpward)
{
  options.track.sides = {core::Side::left};
  const MarkerArray markers = draw();
  const Marker& arrow = findMarker(markers, "force", 0);
  const double length = options.patch.force_scale * result.patches[0].normal_force;
  EXPECT_LT(inPicture(arrow, arrow.points[0]).norm(), 1e-9);
  EXPECT_LT((inPicture(arrow, arrow.points[1]) - Eigen::Vector3d(0, 0, -length)).norm(), 1e-9);
}

TEST_F(FollowedContact, BothContactsAreSideBySide)
{
  const MarkerArray markers = draw();
  for (const int side : {0, 1})
  {
    const Marker& arrow = findMarker(markers, "force", 16 * side);
    const Eigen::Vector3d expected(0, (side == 0 ? 0.5 : -0.5) * spacing, 0);
    EXPECT_LT((inPicture(arrow, arrow.points[0]) - expected).norm(), 1e-9) << "side " << side;
  }
}

TEST_F(FollowedContact, PictureIsRigid)
{
  const MarkerArray there = sceneMarkers(output, &config.model, trail, options), here = draw();
  for (const char* ns : {"rail", "wheel", "zoom"})
  {
    const Marker &a = findMarker(there, ns, 0), &b = findMarker(here, ns, 0);
    ASSERT_EQ(a.points.size(), b.points.size());
    const auto distance = [](const Marker& marker)
    { return (inPicture(marker, marker.points.front()) - inPicture(marker, marker.points.back())).norm(); };
    EXPECT_NEAR(distance(a), distance(b), 1e-9) << ns;
  }
}

TEST_F(FollowedContact, LastFrameRemainsWithoutContact)
{
  const Eigen::Vector3d with_contact = firstRailPoint(0);
  result.patches.erase(result.patches.begin());
  EXPECT_LT((firstRailPoint(0) - with_contact).norm(), 1e-9) << "lift-off";
  output.result = nullptr;
  output.state.z = 0.46;
  EXPECT_LT((firstRailPoint(0) - with_contact).norm(), 1e-9) << "not usable";
  view.clear();
  EXPECT_GT((firstRailPoint(0) - with_contact).norm(), 0.01) << "the frame is no longer known";
}

TEST_F(FollowedContact, RailAtRestIsFollowedBeforeTheFirstContact)
{
  options.track.sides = {core::Side::right};
  output.result = nullptr;
  const core::PlacedRail at_rest = core::restingRail(config.model, core::Side::right);
  const core::PlanePoint reference = at_rest.referencePoint(), end = at_rest.at(at_rest.profile().parts()[0].begin);
  const Eigen::Vector3d expected(-0.5 * options.track.rail_length, reference.y - end.y, end.z - reference.z);
  EXPECT_LT((firstRailPoint(1) - expected).norm(), 1e-9);
}

TEST(ContactFrame, MovesContinuouslyAsTheLoadMovesToAnotherPatch)
{
  core::WheelsetResult result;
  result.patches.resize(2);
  result.patches[0].pose = {0, 0.75, 0, 0.05};
  result.patches[1].pose = {0.01, 0.72, -0.012, 1.1};
  const auto frame = [&](double share)
  {
    result.patches[0].normal_force = (1 - share) * 1e5;
    result.patches[1].normal_force = share * 1e5;
    return *contactFrame(result, core::Side::left);
  };
  EXPECT_LT((frame(0).translation() - Eigen::Vector3d(0, 0.75, 0)).norm(), 1e-12);
  EXPECT_LT((frame(1).translation() - Eigen::Vector3d(0.01, 0.72, -0.012)).norm(), 1e-12);
  const auto angle = [](const Eigen::Isometry3d& f) { return std::atan2(f(2, 1), f(1, 1)); };
  EXPECT_NEAR(angle(frame(0)), 0.05, 1e-12);
  EXPECT_NEAR(angle(frame(1)), 1.1, 1e-12);
  EXPECT_NEAR(angle(frame(0.5)), 0.575, 1e-12) << "equal forces: half way";
  for (double share = 0; share < 1; share += 0.01)
  {
    EXPECT_LT(std::abs(angle(frame(share + 0.01)) - angle(frame(share))), 0.02) << "at most twice the mean change";
  }
}

TEST(ContactFrame, WheelWithoutLoadHasNone)
{
  core::WheelsetResult result;
  EXPECT_FALSE(contactFrame(result, core::Side::left));
  result.patches.resize(1);
  result.patches[0].normal_force = 1;
  EXPECT_TRUE(contactFrame(result, core::Side::left));
  EXPECT_FALSE(contactFrame(result, core::Side::right));
}
}  // namespace
