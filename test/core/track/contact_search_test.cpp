// SPDX-License-Identifier: BSD-3-Clause
#include "../../manchester_scene.h"
#include "../../seeded.h"
#include "dense_separation.h"

using namespace wheel_rail_contact::core;

namespace
{
/// One wheel and its deflected rail, in side axes.
struct Scene
{
  Scene(const ContactModelConfig& config, Side side, const WheelsetPose& pose, const RailDeflection& bent)
      : rail(PlacedRail(config.rail_profile.left, config.track, Side::left).deflected(bent)),
        wheel(*config.wheel_profile.left, config.wheelset, Side::left, toSide(side, pose))
  {
    const WheelsetPose& seen = wheel.pose();
    std::ostringstream out;
    out.precision(9);
    out << "pose in side axes: y " << seen.y << " yaw " << seen.yaw << " roll " << seen.roll << "; rail deflected by "
        << bent.lateral << " outward, " << bent.vertical << " up, roll " << bent.roll;
    description = out.str();
  }
  std::string description;  ///< for messages
  PlacedRail rail;
  PlacedWheel wheel;
};

/// Interval in which the separation by brute force is below a given value.
struct DenseInterval
{
  double begin, end;    ///< y in side axes [m]
  std::size_t station;  ///< station of the smallest separation
  double lowest;        ///< smallest separation [m]
};

/// Largest depth of a minimum below the stations of the search, which are 0.25 mm apart [m]: curvature / 2 * (0.125
/// mm)². The curvature is 2^1.5 / 13 mm where the rail is less steep than 45 degrees, and `sharpest` on the flank.
double stationError(const DenseSeparation& dense, std::size_t station)
{
  const bool flank = dense.railHeight(station + 1) - dense.railHeight(station) > DenseSeparation::spacing;
  return 0.5 * (flank ? sharpest : std::pow(2, 1.5) / 0.013) * 0.125e-3 * 0.125e-3;
}

std::vector<DenseInterval> intervalsBelow(const DenseSeparation& dense, double level)
{
  std::vector<DenseInterval> found;
  for (std::size_t k = 0; k < dense.size(); ++k)
  {
    if (dense.at(k) < level)
    {
      DenseInterval interval{dense.y(k), 0, k, dense.at(k)};
      for (; k < dense.size() && dense.at(k) < level; ++k)
      {
        interval.end = dense.y(k);
        if (dense.at(k) < interval.lowest)
        {
          interval.lowest = dense.at(k);
          interval.station = k;
        }
      }
      found.push_back(interval);
    }
  }
  return found;
}

class ContactSearchTest : public testing::Test
{
 protected:
  double unit() { return random_.unit(); }
  Scene randomScene(Side side, double yaw)
  {
    const WheelsetPose pose{0.012 * unit(), 0.46, yaw * unit(), 0.01 * unit()};
    return {config_, side, pose, {3e-3 * unit(), 1e-3 * unit(), 0.01 * unit()}};
  }
  void place(const Scene& scene)
  {
    search_.setRail(scene.rail);
    search_.setWheel(scene.wheel);
  }
  std::vector<OverlapInterval> intervals(double separation) const { return intervalsOf(search_, separation); }

  Seeded random_{20111U};
  ContactModelConfig config_ = manchesterScene();
  ContactSearch search_{*config_.wheel_profile.left, *config_.rail_profile.left};
};

// The position found must be a point of both bodies and have the smallest separation. Among positions whose separations
// differ by less than the error of the stations, the search takes the one with the lowest station. It also stays at a
// station if the minimum is not next to it. Both cases are rare.
TEST_F(ContactSearchTest, NearestPositionAgreesWithBruteForce)
{
  int exact = 0;
  for (int i = 0; i < 200; ++i)
  {
    const Scene scene = randomScene(i % 2 == 0 ? Side::left : Side::right, i % 3 == 0 ? 0.06 : 0.02);
    place(scene);
    const InitialContact contact = nearestOf(search_);
    SCOPED_TRACE(scene.description);
    const DenseSeparation dense(scene.wheel, scene.rail);
    const std::size_t lowest = dense.lowest();
    exact += contact.separation < dense.at(lowest) + dense_error ? 1 : 0;
    EXPECT_GT(contact.separation, dense.at(lowest) - dense_error);
    EXPECT_LT(contact.separation, dense.at(lowest) + stationError(dense, lowest))
        << contact.y << " found, expected " << dense.y(lowest);

    const PlanePoint rail = scene.rail.at(contact.rail_u);
    SpacePoint wheel{};
    ASSERT_TRUE(scene.wheel.locus(config_.wheel_profile.left->at(contact.wheel_u), wheel));
    EXPECT_NEAR(rail.y, contact.y, 1e-10);  // the search ends at 1e-11 m
    EXPECT_NEAR(wheel.y, contact.y, 1e-10);
    EXPECT_NEAR(wheel.z - rail.z, contact.separation, 3e-10);
    EXPECT_NEAR(rail.dz / rail.dy, contact.slope, 1e-9);
  }
  EXPECT_GE(exact, 194);  // of 200; 1.2 inexact ones are expected (15 of 2500)
}

// Wheel and rail are parallel at a minimum. The position is exact to 10 nm, and the relative curvature is below 3200
// 1/m. Positions at which the search stayed at a station are not minima of smooth bodies.
TEST_F(ContactSearchTest, OutlinesAreParallelAtTheNearestPosition)
{
  int smooth = 0;
  for (int i = 0; i < 200; ++i)
  {
    const Scene scene = randomScene(i % 2 == 0 ? Side::left : Side::right, 0.03);
    place(scene);
    const InitialContact contact = nearestOf(search_);
    SpacePoint locus{};
    PlanePoint wheel{};
    const CurvePoint point = config_.wheel_profile.left->at(contact.wheel_u);
    ASSERT_TRUE(scene.wheel.locus(point, locus));
    ASSERT_TRUE(scene.wheel.section(point, locus.x, wheel));
    if (contact.curvature > 0 && std::abs(wheel.dz / wheel.dy - contact.slope) < 4e-5)
    {
      ++smooth;
    }
  }
  EXPECT_GE(smooth, 190);  // some minima are corners: a step of S1002 between sections, or an end of the rail
}

// Each interval of the brute force must be in an interval of the search if it is deeper than the error of the stations.
// Each interval of the search, except on the flank, must contain one of the brute force.
//
// The ends of the intervals only determine the first grid, which grows until it covers the overlap. They are
// interpolated between stations or computed from the curvature at the minimum. The separation there may differ from the
// given value by the depth (the grid is then too wide or too narrow by sqrt(2)). On the flank, where the curvature
// jumps at a section boundary, the difference may be larger.
TEST_F(ContactSearchTest, OverlapIntervalsAgreeWithBruteForce)
{
  for (int i = 0; i < 200; ++i)
  {
    const Scene scene = randomScene(i % 2 == 0 ? Side::left : Side::right, i % 3 == 0 ? 0.06 : 0.02);
    place(scene);
    SCOPED_TRACE(scene.description);
    const DenseSeparation dense(scene.wheel, scene.rail);
    const double lowest = dense.at(dense.lowest());
    for (const double depth : {1e-5, 5e-5, 2e-4, 1e-3})
    {
      const double level = lowest + depth;
      const std::vector<DenseInterval> expected = intervalsBelow(dense, level);
      const std::vector<OverlapInterval> found = intervals(level);
      for (const DenseInterval& interval : expected)
      {
        const double y = dense.y(interval.station);
        const bool held = std::any_of(
            found.begin(), found.end(),
            [&](const OverlapInterval& candidate)
            { return y > scene.rail.at(candidate.u_begin).y - 2e-5 && y < scene.rail.at(candidate.u_end).y + 2e-5; });
        EXPECT_TRUE(held || level - interval.lowest < stationError(dense, interval.station))
            << "interval not found: " << interval.begin << " to " << interval.end << ", depth "
            << level - interval.lowest;
      }
      for (const OverlapInterval& interval : found)
      {
        if (interval.contact.slope < 1)
        {
          EXPECT_LT(dense.near(interval.contact.y), level + dense_error) << "no overlap by brute force";
          EXPECT_NEAR(dense.near(scene.rail.at(interval.u_begin).y), level, depth);
          EXPECT_NEAR(dense.near(scene.rail.at(interval.u_end).y), level, depth);
        }
      }
    }
  }
}

// Intervals neither overlap nor touch: between two of them there is a place without overlap.
TEST_F(ContactSearchTest, IntervalsAreSeparateAndInOrder)
{
  int apart = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Scene scene = randomScene(i % 2 == 0 ? Side::left : Side::right, 0.06);
    place(scene);
    const InitialContact contact = nearestOf(search_);
    SCOPED_TRACE(scene.description);
    const std::vector<OverlapInterval> found =
        intervals(contact.separation + (i < 1000 ? 6e-3 : 2e-4) * std::abs(unit()));
    for (std::size_t k = 0; k < found.size(); ++k)
    {
      EXPECT_LE(found[k].u_begin, found[k].u_end);
      if (k + 1 < found.size())
      {
        EXPECT_LT(found[k].u_end, found[k + 1].u_begin);
        ++apart;
      }
    }
  }
  EXPECT_GE(apart, 5);
}

// At about 5 mm of lateral displacement the contact moves from the tread to the flange root, and both touch. The search
// must find two intervals with very different normals, each about its own minimum.
TEST_F(ContactSearchTest, TreadAndFlangeContactAreTwoIntervals)
{
  int with_two = 0;
  for (double y = 4.8e-3; y < 5.4e-3; y += 2e-5)
  {
    const Scene scene(config_, Side::left, {y, 0.46, 0, 0}, {});
    place(scene);
    SCOPED_TRACE(scene.description);
    const DenseSeparation dense(scene.wheel, scene.rail);
    const double level = dense.at(dense.lowest()) + 4e-5;
    const std::vector<DenseInterval> expected = intervalsBelow(dense, level);
    if (expected.size() != 2 || level - std::max(expected[0].lowest, expected[1].lowest) < 1e-6)
    {
      continue;
    }
    ++with_two;
    const std::vector<OverlapInterval> found = intervals(level);
    ASSERT_EQ(found.size(), 2U) << "y " << y;
    EXPECT_LT(found[0].u_end, found[1].u_begin);
    EXPECT_GT(std::atan(found[0].contact.slope) - std::atan(found[1].contact.slope), 0.1);
    for (std::size_t k = 0; k < 2; ++k)
    {
      EXPECT_NEAR(found[k].contact.separation, expected[k].lowest, dense_error);
      EXPECT_GT(found[k].contact.rail_u, found[k].u_begin);
      EXPECT_LT(found[k].contact.rail_u, found[k].u_end);
    }
  }
  EXPECT_GE(with_two, 10);
}

// The ends are accurate to one station (0.25 mm). An interval may seem to shrink by this amount where its width is no
// longer computed from the curvature at the minimum, but from the stations.
TEST_F(ContactSearchTest, IntervalsWidenWithTheSeparation)
{
  for (int i = 0; i < 50; ++i)
  {
    const Scene scene = randomScene(Side::left, 0.02);
    place(scene);
    const InitialContact contact = nearestOf(search_);
    OverlapInterval before;
    double first_width = 0;
    for (double depth = 2e-4; depth < 4e-3; depth *= 1.3)
    {
      const std::vector<OverlapInterval> found = intervals(contact.separation + depth);
      const auto around = std::find_if(found.begin(), found.end(),
                                       [&](const OverlapInterval& one)
                                       { return one.u_begin < contact.rail_u && one.u_end > contact.rail_u; });
      ASSERT_NE(around, found.end());
      const OverlapInterval& interval = *around;
      if (before.u_end > 0)
      {
        EXPECT_LE(interval.u_begin, before.u_begin + 2.5e-4);
        EXPECT_GE(interval.u_end, before.u_end - 2.5e-4);
      }
      first_width = first_width > 0 ? first_width : interval.u_end - interval.u_begin;
      before = interval;
    }
    EXPECT_GT(before.u_end - before.u_begin, 1.5 * first_width);
  }
}

TEST_F(ContactSearchTest, ThereIsNoOverlapAboveTheFirstTouchNorBesideTheRail)
{
  place({config_, Side::left, {0, 0.46, 0, 0}, {}});
  const InitialContact contact = nearestOf(search_);
  EXPECT_TRUE(intervals(contact.separation - 1e-9).empty());
  EXPECT_FALSE(intervals(contact.separation + 2e-4).empty());
  for (const double y : {-0.3, 0.3})
  {
    place({config_, Side::left, {y, 0.46, 0, 0}, {}});
    InitialContact none;
    EXPECT_FALSE(search_.nearest(none));
    EXPECT_TRUE(intervals(1.0).empty());
  }
}

// At 60 mrad of yaw the outline of the flange root is folded. The search must find the lower branch.
TEST_F(ContactSearchTest, LowerBranchOfAFoldedOutlineIsFoundAtLargeYaw)
{
  int folded = 0;
  for (int i = 0; i < 40; ++i)
  {
    const double yaw = i % 2 == 0 ? 0.06 : -0.06;
    const Scene scene(config_, Side::left, {0.004 + 0.006 * std::abs(unit()), 0.46, yaw, 0}, {});
    place(scene);
    double y_before = -1;
    bool turns_back = false;
    for (double u = 0.012; u < config_.wheel_profile.left->length(); u += 1e-4)
    {
      SpacePoint locus{};
      ASSERT_TRUE(scene.wheel.locus(config_.wheel_profile.left->at(u), locus));
      turns_back = turns_back || locus.y < y_before;
      y_before = locus.y;
    }
    folded += turns_back ? 1 : 0;
    const InitialContact contact = nearestOf(search_);
    SCOPED_TRACE(scene.description);
    const DenseSeparation dense(scene.wheel, scene.rail);
    EXPECT_GT(contact.separation, dense.at(dense.lowest()) - dense_error);
    EXPECT_LT(contact.separation, dense.at(dense.lowest()) + stationError(dense, dense.lowest()));
  }
  EXPECT_GT(folded, 0);
}
}  // namespace
