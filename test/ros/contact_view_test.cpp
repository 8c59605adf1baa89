// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/contact_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/balance/rail_support.h"
#include "result_scene.h"

using namespace wheel_rail_contact;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

namespace
{
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
}  // namespace

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
