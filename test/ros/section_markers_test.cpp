// SPDX-License-Identifier: BSD-3-Clause
// Drawn rails whose profile changes along the line.
#include <set>

#include "../core/balance/crossing_scene.h"
#include "core/balance/rail_support.h"
#include "result_scene.h"
#include "ros/markers/contact_scene.h"
#include "ros/markers/track_markers.h"

using namespace wheel_rail_contact;
namespace
{
constexpr double x = 3;  ///< of the picture [m]

class SectionMarkers : public testing::Test
{
 protected:
  Marker rail(core::Side side, double distance, double length)
  {
    TrackStyle style;
    style.rail_length = length;
    MarkerArray markers;
    addRails(model_, style, {x, distance}, {}, markers);
    return findMarker(markers, "rail", static_cast<int>(side));
  }

  /// Distance of a point from the nearest part of the left rail at a place of the line [m].
  double distanceFromRail(const geometry_msgs::Point& p, double place) const
  {
    const core::PlacedRail there = core::restingRail(model_, core::Side::left, place);
    double least = 1;
    for (const core::ParameterRange& part : there.profile().parts())
    {
      for (double u = part.begin; u <= part.end; u += 2e-4)
      {
        const core::PlanePoint q = there.at(u);
        least = std::min(least, std::hypot(q.y - p.y, q.z - p.z));
      }
    }
    return least;
  }

  core::ContactModelConfig model_ = core::crossing_scene::scene();
};
}  // namespace

TEST_F(SectionMarkers, DrawnPointsLieOnTheRailOfTheirPlace)
{
  for (const double distance : {-0.2, 0.1, 0.5})
  {
    const Marker drawn = rail(core::Side::left, distance, 0.4);
    ASSERT_FALSE(drawn.points.empty());
    for (const auto& p : drawn.points)
    {
      // Points of the rail are 0.2 mm apart. Curves between two sections end above the deeper one of them.
      EXPECT_TRUE(p.z < -0.025 || distanceFromRail(p, distance + p.x - x) < 1.5e-4) << p.x << " " << p.y;
    }
  }
}

// All edges of the drawn triangles lie on the rail or along it: none crosses the gap between nose and wing rail.
TEST_F(SectionMarkers, NothingIsDrawnBetweenTwoParts)
{
  const double place = 0.5,
               longest = 0.005 + 0.05 * core::crossing_scene::slope;  // spacing of points, and the wing rail
  const Marker drawn = rail(core::Side::left, place, 0.2);
  for (std::size_t i = 0; i < drawn.points.size(); ++i)
  {
    const auto &a = drawn.points[i], &b = drawn.points[i % 3 == 2 ? i - 2 : i + 1];
    EXPECT_LT(std::hypot(a.y - b.y, a.z - b.z), longest);
  }
}

TEST_F(SectionMarkers, NoseIsDrawnFromItsBeginning)
{
  const Marker drawn = rail(core::Side::left, core::crossing_scene::nose_begin, 0.4);
  double first = 1e3;
  for (const auto& p : drawn.points)
  {
    // The wing rail is at least 0.7175 m + x / 10 from the track centre.
    const double place = core::crossing_scene::nose_begin + p.x - x;
    first = p.y < 0.7175 + core::crossing_scene::slope * place - 0.005 ? std::min(first, place) : first;
  }
  EXPECT_NEAR(first, core::crossing_scene::nose_begin, 1e-9);
}

TEST_F(SectionMarkers, ConstantRailIsDrawnFromItsTwoEnds)
{
  const Marker drawn = rail(core::Side::right, 0.5, 0.4);
  for (const auto& p : drawn.points)
  {
    EXPECT_NEAR(std::abs(p.x - x), 0.2, 1e-12);
  }
}

TEST_F(SectionMarkers, EachPartAtRestIsALineOfItsOwn)
{
  MarkerArray markers;
  addRailsAtRest(model_, TrackStyle(), {x, 0.5}, markers);
  ASSERT_EQ(markers.markers.size(), 3U);
  std::set<int> ids;
  for (const Marker& marker : markers.markers)
  {
    EXPECT_EQ(marker.type, Marker::LINE_STRIP);
    EXPECT_TRUE(ids.insert(marker.id).second);
    for (std::size_t i = 1; i < marker.points.size(); ++i)
    {
      EXPECT_LT(std::abs(marker.points[i].y - marker.points[i - 1].y), 0.005);
    }
  }
}

TEST_F(SectionMarkers, SceneShowsTheRailOfTheDistance)
{
  core::WheelsetResult result;
  result.status = core::ContactStatus::ok;
  ContactOutput output;
  output.result = unowned(result);
  output.state.x = result.x = x;
  output.state.distance = 0.7;
  const MarkerArray scene = sceneMarkers(output, &model_, ContactTrail(), SceneOptions());
  const auto drawn = findMarker(scene, "rail", 0).points, expected = rail(core::Side::left, 0.7, 0.4).points;
  ASSERT_EQ(drawn.size(), expected.size());
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    EXPECT_EQ(drawn[i].y, expected[i].y);
  }
}

TEST_F(SectionMarkers, PlaceOnTheLineIsInTheMessage)
{
  ContactOutput output;
  output.state.x = 3;
  output.state.distance = 12.5;
  const WheelsetContact message = toMessage(output, true);
  EXPECT_EQ(message.distance, 12.5);
  EXPECT_EQ(message.wheelset.position.x, 3);
  EXPECT_EQ(outputFromMessage(message).state.distance, 12.5);
}
