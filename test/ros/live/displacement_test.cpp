// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/PointStamped.h>
#include <gtest/gtest.h>

#include <limits>

#include <wheel_rail_contact/RailDisplacements.h>
#include "contact_client.h"

using namespace wheel_rail_contact;

namespace
{
/// Client that also publishes the displacements of both rails and the place along the line.
class Track
{
 public:
  Track()
      : displacement_(nh_.advertise<RailDisplacements>("/displaced/wheelset/rail_displacement", 10)),
        distance_(nh_.advertise<geometry_msgs::PointStamped>("/displaced/wheelset/distance", 10))
  {
    EXPECT_TRUE(
        spinUntil([this] { return displacement_.getNumSubscribers() > 0 && distance_.getNumSubscribers() > 0; }));
  }

  /// Publishes displacements with a stamp.
  void displace(RailDisplacements displacements, const ros::Time& stamp)
  {
    displacements.header.stamp = stamp;
    displacement_.publish(displacements);
  }

  /// Result for a wheelset at y [m] with 100 kN on each wheel.
  WheelsetContact request(double y, const RailDisplacements& displacements, double distance = 0)
  {
    const ros::Time stamp = ContactClient::nextStamp();
    const std::size_t before = client_.results().size();
    client_.send(ContactClient::pose(y, stamp));
    client_.send(ContactClient::load(-200e3, stamp));
    geometry_msgs::PointStamped place;
    place.header.stamp = stamp;
    place.point.x = distance;
    distance_.publish(place);
    spinUntil([] { return false; }, 0.1);
    EXPECT_EQ(client_.results().size(), before) << "evaluated without the displacements of the rails";
    displace(displacements, stamp);
    EXPECT_TRUE(client_.waitForResults(before + 1));
    return client_.results().size() > before ? client_.results().back() : WheelsetContact();
  }

 private:
  ros::NodeHandle nh_;
  ContactClient client_{"/displaced", "/displaced/contact_node"};
  ros::Publisher displacement_, distance_;
};

RailDisplacements shifted(double left, double right, double vertical)
{
  RailDisplacements displacements;
  displacements.left.lateral = left;
  displacements.right.lateral = right;
  displacements.left.vertical = displacements.right.vertical = vertical;
  return displacements;
}
}  // namespace

// Both rails move 3 mm to the left and 2 mm up: the contact is that of a wheelset 3 mm further to the right, 2 mm
// higher.
TEST(LiveNode, RailsDisplacedTogetherMoveTheContactWithThem)
{
  Track track;
  const auto moved = track.request(4e-3, shifted(3e-3, -3e-3, 2e-3));
  const auto same = track.request(1e-3, RailDisplacements());
  ASSERT_EQ(moved.status, WheelsetContact::OK) << moved.status_text;
  EXPECT_EQ(moved.left_rail.lateral, 3e-3);
  EXPECT_EQ(moved.right_rail.lateral, -3e-3);
  EXPECT_EQ(moved.left_rail.given_lateral, 3e-3);
  EXPECT_EQ(moved.right_rail.given_vertical, 2e-3);
  // Rounding moves the grids on the profile slightly; the height is accurate to the tolerance of the balance.
  EXPECT_NEAR(moved.wheelset.position.z - same.wheelset.position.z, 2e-3, 1e-7);
  ASSERT_EQ(moved.patches.size(), same.patches.size());
  for (std::size_t i = 0; i < moved.patches.size(); ++i)
  {
    EXPECT_NEAR(moved.patches[i].pose.position.y - same.patches[i].pose.position.y, 3e-3, 1e-5);
    EXPECT_NEAR(moved.patches[i].max_pressure, same.patches[i].max_pressure, 0.01 * same.patches[i].max_pressure);
  }
}

TEST(LiveNode, NonFiniteDisplacementOrDistanceIsRefused)
{
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  Track track;
  const auto displaced = track.request(0, shifted(0, not_a_number, 0));
  EXPECT_EQ(displaced.status, WheelsetContact::INVALID_INPUT);
  EXPECT_EQ(displaced.status_text, "right rail displacement is not finite");
  const auto nowhere = track.request(0, RailDisplacements(), not_a_number);
  EXPECT_EQ(nowhere.status, WheelsetContact::INVALID_INPUT);
  EXPECT_EQ(nowhere.status_text, "distance: point.x is not finite");
  const auto far = track.request(0, shifted(0.11, 0, 0));
  EXPECT_EQ(far.status, WheelsetContact::INVALID_INPUT);
  EXPECT_NE(far.status_text.find("displacement of a rail"), std::string::npos) << far.status_text;
  EXPECT_EQ(track.request(0, RailDisplacements(), 1e6).status, WheelsetContact::OK);
}

TEST(LiveNode, DisplacementWithoutAPairIsCountedAsDropped)
{
  Track track;
  const std::string dropped = "messages dropped: no message with a matching stamp";
  ASSERT_EQ(track.request(0, RailDisplacements()).status, WheelsetContact::OK);
  const Report before = nextReport("/displaced/contact_node");
  track.displace(RailDisplacements(), ContactClient::nextStamp());
  ASSERT_EQ(track.request(0, RailDisplacements()).status, WheelsetContact::OK);
  const Report after = nextReport("/displaced/contact_node");
  EXPECT_EQ(std::stoi(after.values.at(dropped)), std::stoi(before.values.at(dropped)) + 1);
  EXPECT_EQ(after.values.at("messages waiting for a match"), "0");
  EXPECT_EQ(std::stoi(after.values.at("messages received")), std::stoi(before.values.at("messages received")) + 5);
}
